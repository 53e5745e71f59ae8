#pragma once

#include "core/document/model.h"
#include "core/document/time/timeline.h"

namespace penpose::document {

/// The timeline as an animation that any viewer can play: weights of shapes and deformers exactly (a stepped one beside
/// others that are not holds up to the last number before its next key), joints sampled `joint_samples_per_s` times a
/// second between their keys. Controls without a key, and keys that a control does not have, are as the curve is there;
/// a control that is never keyed is as in the model's pose. Empty for a timeline without keys.
[[nodiscard]] Animation to_animation(const Model& model, const Timeline& timeline, double joint_samples_per_s = 60);

}  // namespace penpose::document
