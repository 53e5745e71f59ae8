#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/portrait/placement.h"
#include "core/portrait/read_drawing.h"
#include "core/portrait/sketch/face_layout.h"

namespace penpose::portrait {

/// The result of reading a drawing by its layout.
struct SketchedPose {
  rig::Pose pose;
  std::vector<LineRead> lines;  ///< one a line
  FaceLayout layout;
  Placement sheet;     ///< where the drawing lies in the camera's picture
  bool rests = false;  ///< it shows no expression
};

/// Reads a drawing the way a person does: finds the face by its layout, measures what its brows, eyes and mouth show
/// beyond what faces at rest are drawn like, draws the same on the model's own features and asks intent::solve for the
/// pose. Returns nothing if the drawing is no face, or the model has no eyes or no mouth. Errors: those of
/// intent::solve.
[[nodiscard]] base::Result<std::optional<SketchedPose>> pose_from_sketch(
    const rig::Rig& rig, const intent::WholeModel& whole, std::span<const FeatureCurve> curves, const Drawing& drawing,
    const geometry::Camera& camera, const rig::Pose& start, std::span<const std::size_t> free);

}  // namespace penpose::portrait
