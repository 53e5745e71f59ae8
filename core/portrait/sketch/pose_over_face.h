#pragma once

#include <span>

#include "core/base/result.h"
#include "core/portrait/read_drawing.h"

namespace penpose::portrait {

/// The pose that lines over a face ask for, once it is known which feature each is: each feature goes where its line
/// was drawn, as a target of a reference curve does (intent::solve). `read` says what the lines are; where a lone line
/// would ask for nothing, it is changed to what the line asks for. Errors: those of intent::solve.
[[nodiscard]] base::Result<rig::Pose> pose_over_face(const rig::Rig& rig, const intent::WholeModel& whole,
                                                     std::span<const FeatureCurve> curves, const Drawing& drawing,
                                                     DrawingRead& reading, const geometry::Camera& camera,
                                                     const rig::Pose& start, std::span<const std::size_t> free);

}  // namespace penpose::portrait
