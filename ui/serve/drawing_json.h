#pragma once

#include <span>

#include "core/base/json/json.h"
#include "core/portrait/feature_curve.h"
#include "core/portrait/read_drawing.h"

namespace penpose::serve {

/// What `penpose draw --json` and the conversation say of a line of a drawing: `curve` (its name, or null), and where
/// there is one `from` and `to` (shares of its length) and `reversed`; of a line that is drawn around something
/// `lower`, the curve of its lower half. `curves`: the feature curves of the face.
[[nodiscard]] json::Json line_json(const portrait::LineRead& line, std::span<const portrait::FeatureCurve> curves);

}  // namespace penpose::serve
