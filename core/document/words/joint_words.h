#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/document/words/face_marks.h"
#include "core/document/words/readable_name.h"
#include "core/intent/model/whole_model.h"

namespace penpose::document {

/// What one parameter of a joint does: "head turns"; "upper arm raises" and left.
using JointWords = ReadableName;

/// Of all parameters; nothing for those that are no joint's, and for joints that move parts of a face, whose words are
/// those of what they do there. `face`: null where the model has none.
[[nodiscard]] std::vector<std::optional<JointWords>> joint_words(const Model& model, const intent::WholeModel& whole,
                                                                 FaceMarks* face);

}  // namespace penpose::document
