#pragma once

#include <vector>

#include "core/geometry/camera.h"
#include "tests/judges/drawing/judged_face.h"

namespace penpose::judges::drawn {

/// The marks of a face as lines.
using Lines = std::vector<portrait::DrawnLine>;

/// The side of a picture of a face, whose marks have a diagonal of 800 px at rest, and its middle.
inline constexpr double k_picture_px = 1200;
inline constexpr geometry::PxPoint k_picture_middle{k_picture_px / 2, k_picture_px / 2};
inline constexpr double k_face_px = 800;

/// What a camera sees of a face's marks, in the size in which hands draw.
class CameraPicture {
 public:
  /// Seen from this side of its front.
  CameraPicture(const JudgedFace& face, double yaw_degrees);

  [[nodiscard]] Lines seen(const rig::Pose& pose) const;
  [[nodiscard]] const Lines& rest() const { return rest_; }
  /// A place of the picture in the picture of the camera by which drawings are read.
  [[nodiscard]] geometry::PxPoint on_camera(const geometry::PxPoint& p) const {
    return middle_ + (p - k_picture_middle) * (1 / scale_);
  }

 private:
  const JudgedFace& face_;
  geometry::Camera camera_;
  geometry::PxPoint middle_;
  double scale_ = 1;
  Lines rest_;
};

/// The mean distance from points of one line to the nearest ones of another, both ways.
[[nodiscard]] double apart(const portrait::DrawnLine& a, const portrait::DrawnLine& b);
/// Root mean square of the distance between points of the same number.
[[nodiscard]] double moved(const portrait::DrawnLine& a, const portrait::DrawnLine& b);

}  // namespace penpose::judges::drawn
