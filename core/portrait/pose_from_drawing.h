#pragma once

#include <span>

#include "core/portrait/read_drawing.h"

namespace penpose::portrait {

/// The pose that a drawing asks for.
struct DrawnPose {
  rig::Pose pose;  ///< all parameters of the rig
  DrawingRead read;
  Placement sheet;  ///< where it lies in the camera's picture
};

/// The pose in which the controls of a face have moved by these shares from `start`; values stay in their ranges.
[[nodiscard]] rig::Pose pose_of(const rig::Rig& rig, const FaceView& face, const rig::Pose& start,
                                std::span<const double> shares);

/// Reads a drawing of a face that is seen by this camera, wherever it lies on its sheet and however large it is.
/// `start`: where nothing has moved; `free`: parameters that may move, ascending. Errors: those of FaceView::make and
/// read_drawing.
[[nodiscard]] base::Result<DrawnPose> pose_from_drawing(const rig::Rig& rig, const intent::WholeModel& whole,
                                                        std::span<const FeatureCurve> curves, const Drawing& drawing,
                                                        const geometry::Camera& camera, const rig::Pose& start,
                                                        std::span<const std::size_t> free);

/// A camera far in front of the curves, turned about +Y (degrees), that shows all of them: how a drawing sees a face.
/// Precondition: the curves' vertices are the rig's.
[[nodiscard]] geometry::Camera camera_of_drawing(const rig::Rig& rig, std::span<const FeatureCurve> curves,
                                                 const rig::Pose& start, double yaw_degrees);

}  // namespace penpose::portrait
