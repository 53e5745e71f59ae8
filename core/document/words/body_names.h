#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/document/words/readable_name.h"
#include "core/intent/model/whole_model.h"
#include "core/portrait/surface/face_frame.h"

namespace penpose::document {

/// How the turns of a joint are spoken of.
enum class JointKind : std::uint8_t { middle, head, eye, jaw, limb, finger, face, other };

/// "upper arm" and left.
struct NamedJoint : ReadableName {
  JointKind kind = JointKind::other;
};

/// Names the joints of a figure by its shape alone, one a joint: legs go to what lies lowest on each side, arms to what
/// lies farthest out, and the head is what is highest. Joints of none of them have no name, and no joint has one if the
/// model is no such figure. `front` has the directions of the figure.
[[nodiscard]] std::vector<std::optional<NamedJoint>> names_by_shape(const intent::WholeModel& whole,
                                                                    const portrait::FaceFrame& front);

}  // namespace penpose::document
