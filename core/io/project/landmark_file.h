#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

/// A named path along vertices of a model.
struct VertexCurve {
  std::string name;
  std::vector<std::uint32_t> vertices;  ///< at least 2, in order along the curve
};

/// Reads a file of landmark curves: {"curves": {NAME: {"vertices": [v0, v1, ...]}}}. Curves come in the order of their
/// names. Errors (place: JSON pointer): a member of another type, a curve of one point.
[[nodiscard]] base::Result<std::vector<VertexCurve>> read_landmarks(base::Bytes bytes);

}  // namespace penpose::io
