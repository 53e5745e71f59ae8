#pragma once

#include <array>
#include <span>

#include "core/document/model.h"
#include "core/geometry/camera.h"
#include "core/geometry/space.h"
#include "core/portrait/feature_curve.h"
#include "ui/app/session/pose_library.h"

namespace penpose::app {

/// What a small square picture shows, model units.
struct PictureFrame {
  geometry::ModelPoint middle{0};
  double side = 1;
  double away = 0;         ///< how far the eye is from the middle; 0: as far as for a face of that side
  double yaw_degrees = 0;  ///< where it is seen from: about +y, from the model's own front
  double pitch_degrees = 0;
  friend bool operator==(const PictureFrame&, const PictureFrame&) = default;
};

/// What pictures of a model's poses show, by FacePart: of a part what its features lie on, of all the whole face.
/// Without features it is what controls move that are found by name as `part_of` does (of the mouth nearer, what those
/// of the lips do); where names say nothing, what most shapes move (render::face_vertices), else the model.
using PictureFrames = std::array<PictureFrame, 4>;
[[nodiscard]] PictureFrames picture_frames(const document::Model& model,
                                           std::span<const portrait::FeatureCurve> features = {});

/// A frame about all that differs between a pose and others, with room around it, as it is seen from the direction of
/// `face`: no wider than that, nor so near that nobody knows what it is of. `face` where nothing differs.
/// Precondition: one value a parameter in each.
[[nodiscard]] PictureFrame frame_of_differences(const document::Model& model, const rig::Pose& pose,
                                                std::span<const rig::Pose> others, const PictureFrame& face);

/// Where a picture with that frame is taken from.
[[nodiscard]] geometry::CameraPose camera_of_frame(const document::Model& model, const PictureFrame& frame);
/// The direction that a camera looks from, in whole steps of five degrees and not from behind, put into a frame.
[[nodiscard]] PictureFrame seen_from(const document::Model& model, PictureFrame frame,
                                     const geometry::CameraPose& camera);

}  // namespace penpose::app
