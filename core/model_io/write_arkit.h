#pragma once

#include <string>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::model_io {

/// A model's first animation, or its pose where it has none, as CSV in the way of Live Link Face: Timecode,
/// BlendShapeCount and a column a blend shape or deformer, a row a frame at `fps` frames a second (timecodes count
/// 60 a second). Controls whose names are ARKit's but for case, separators and "_L" for "Left" are written in ARKit's
/// own way. Errors: no control that has weights, more than 1,000,000 frames.
[[nodiscard]] base::Result<std::string> write_arkit(const document::Model& model, double fps = 60);

}  // namespace penpose::model_io
