#include "tests/judges/drawing/known/camera_picture.h"

#include <algorithm>
#include <cmath>

#include "tests/judges/cases/picture.h"
#include "tests/judges/drawing/curve_places.h"
#include "tests/judges/hands/hand.h"

namespace penpose::judges::drawn {

using geometry::PxPoint;

CameraPicture::CameraPicture(const JudgedFace& face, double yaw_degrees)
    : face_(face),
      camera_(portrait::camera_of_drawing(face.rig(), face.marks, rig::rest_pose(face.rig()), yaw_degrees)) {
  PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
  for (const auto& line : places_of(face.marks, face.rest)) {
    for (const auto& place : line) {
      const PxPoint p = camera_.project(place).value_or(PxPoint{});
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  middle_ = (low + high) * 0.5;
  scale_ = k_face_px / std::max(geometry::distance(low, high), 1e-9);
  rest_ = seen(rig::rest_pose(face.rig()));
}

Lines CameraPicture::seen(const rig::Pose& pose) const {
  Lines lines;
  for (const auto& places : places_of(face_.marks, posed(face_.model(), pose))) {
    portrait::DrawnLine line;
    for (const auto& place : places)
      line.push_back(k_picture_middle + (camera_.project(place).value_or(PxPoint{}) - middle_) * scale_);
    lines.push_back(std::move(line));
  }
  return lines;
}

double apart(const portrait::DrawnLine& a, const portrait::DrawnLine& b) {
  constexpr std::size_t k_points = 40;
  const auto one = resampled(a, k_points), other = resampled(b, k_points);
  const auto to = [](const PxPoint& p, const std::vector<PxPoint>& line) {
    double least = 1e300;
    for (const PxPoint& q : line) least = std::min(least, geometry::distance(p, q));
    return least;
  };
  double sum = 0;
  for (std::size_t i = 0; i < k_points; ++i) sum += to(one[i], other) + to(other[i], one);
  return sum / (2 * k_points);
}

double moved(const portrait::DrawnLine& a, const portrait::DrawnLine& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += geometry::dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(a.size(), 1)));
}

}  // namespace penpose::judges::drawn
