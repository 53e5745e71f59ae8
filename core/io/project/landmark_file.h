#pragma once

#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/features/vertex_curve.h"

namespace penpose::io {

using document::VertexCurve;

/// Reads a file of landmark curves: {"curves": {NAME: {"vertices": [v0, v1, ...]}}}. Curves come in the order of their
/// names. Errors (place: JSON pointer): a member of another type, a curve of one point.
[[nodiscard]] base::Result<std::vector<VertexCurve>> read_landmarks(base::Bytes bytes);

}  // namespace penpose::io
