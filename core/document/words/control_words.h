#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "core/document/words/readable_name.h"
#include "core/intent/model/whole_model.h"
#include "core/portrait/feature_curve.h"

namespace penpose::document {

/// What a control does, in words: "smile" and left, "upper lid down" and right. Never empty.
struct ControlWords : ReadableName {
  std::string below = {};  ///< what it does below its rest, where that has words of its own; else empty
};

/// One a parameter of the rig, each text once. They come from the features that the control moves (document/features)
/// and from the joint that it turns; a name decides between meanings that are near, and speaks where the model shows
/// nothing. Sketched controls keep the name that they were given. The same model gives the same words. Measured once
/// for a model. `whole` is that of the rig; without features joints alone have words of what they do.
[[nodiscard]] std::vector<ControlWords> control_words(const Model& model, const intent::WholeModel& whole,
                                                      std::span<const portrait::FeatureCurve> features);

}  // namespace penpose::document
