#pragma once

#include <optional>

#include "core/base/result.h"
#include "core/geometry/space.h"

namespace penpose::geometry {

/// What a camera file says: a pinhole that looks from `eye` at `look_at`.
struct CameraPose {
  ModelPoint eye{0, 0, 1};
  ModelPoint look_at{0, 0, 0};
  ModelVector up{0, 1, 0};
  double vertical_fov_degrees = 30;
  friend bool operator==(const CameraPose&, const CameraPose&) = default;
};

/// Size of the picture in px.
struct Viewport {
  int width = 1000;
  int height = 1000;
  friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// A camera pose with a viewport: maps model points to px and px to rays. Immutable.
class Camera {
 public:
  /// Errors: eye equals look_at, up parallel to the view, field of view outside 1..179 degrees, empty viewport, not
  /// finite.
  static base::Result<Camera> make(const CameraPose& pose, Viewport viewport);

  [[nodiscard]] const CameraPose& pose() const { return pose_; }
  [[nodiscard]] Viewport viewport() const { return viewport_; }
  [[nodiscard]] const ModelPoint& eye() const { return pose_.eye; }
  [[nodiscard]] const ModelVector& right() const { return right_; }
  [[nodiscard]] const ModelVector& up() const { return up_; }
  [[nodiscard]] const ModelVector& forward() const { return forward_; }

  /// Where the point appears; nothing when it lies at or behind the eye's plane.
  [[nodiscard]] std::optional<PxPoint> project(const ModelPoint& point) const;
  /// Distance of the point along the viewing direction (model units); negative behind the eye.
  [[nodiscard]] double depth(const ModelPoint& point) const;
  /// The ray from the eye through a px position; its direction has length one.
  [[nodiscard]] Ray ray(PxPoint position) const;
  /// Model units that one px spans at a given depth.
  [[nodiscard]] double units_per_px(double depth) const { return depth * 2.0 * half_height_ / viewport_.height; }

 private:
  Camera() = default;

  CameraPose pose_;
  Viewport viewport_;
  ModelVector right_{1, 0, 0};
  ModelVector up_{0, 1, 0};
  ModelVector forward_{0, 0, -1};
  double half_height_ = 1;  ///< of the image plane at distance 1
};

/// A camera that shows the whole box from a direction, turned about +Y by `yaw_degrees` (0: from +Z, 90: from +X) and
/// raised by `pitch_degrees`, with a margin of a twelfth of the picture. Works for boxes of any size; an empty box
/// and one that is not finite count as a unit box, one without extent as a unit box around it. The field of view is
/// clamped to 1..179 degrees; an angle that is not finite counts as the one by default.
[[nodiscard]] Camera frame_box(const Box& box, Viewport viewport, double yaw_degrees, double pitch_degrees = 0,
                               double vertical_fov_degrees = 30);

}  // namespace penpose::geometry
