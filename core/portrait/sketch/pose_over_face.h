#pragma once

#include <span>

#include "core/base/result.h"
#include "core/portrait/read_drawing.h"

namespace penpose::portrait {

/// Finds the pose that labelled lines over a face ask for: each feature goes where its line was drawn, as a target of a
/// reference curve does (intent::solve). A whole face that `reading` found at rest stays at rest. Changes the labels in
/// `reading` where another feature is meant. Errors: those of intent::solve.
[[nodiscard]] base::Result<rig::Pose> pose_over_face(const rig::Rig& rig, const intent::WholeModel& whole,
                                                     std::span<const FeatureCurve> curves, const Drawing& drawing,
                                                     DrawingRead& reading, const geometry::Camera& camera,
                                                     const rig::Pose& start, std::span<const std::size_t> free);

}  // namespace penpose::portrait
