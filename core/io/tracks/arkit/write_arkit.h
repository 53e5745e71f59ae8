#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// What write_arkit wrote.
struct ArkitText {
  std::string text;
  std::vector<std::string> notes;  ///< what the format has no place for, one line each
};

/// A model's first animation, or its pose where it has none, as CSV in the way of Live Link Face: Timecode,
/// BlendShapeCount, ARKit's 52 blend shapes and the turns of head and eyes (radians), a row a frame at `fps` frames a
/// second. Controls are found by name as the reader's are (rig::controls_named); shapes that the model lacks are 0.
/// Where the model has a shape of ARKit's for each side (browInnerUp_L and _R) the mean of both is written: the reader
/// gives it to both again, and no other value is nearer to the two. The turn of the head is how far its joint
/// (document::head_joints), or else the first root, has turned from rest with all that carries it; eyes are left at 0.
/// Errors: no control of one of ARKit's names, more than 1,000,000 frames.
[[nodiscard]] base::Result<ArkitText> write_arkit(const document::Model& model, double fps = 60);

}  // namespace penpose::io
