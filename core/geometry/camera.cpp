#include "core/geometry/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"

namespace penpose::geometry {
namespace {

bool finite(const ModelVector& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

base::Result<Camera> Camera::make(const CameraPose& pose, Viewport viewport) {
  if (viewport.width < 1 || viewport.height < 1) {
    return base::Error{"the viewport is empty", "viewport", "give a width and a height of at least one px"};
  }
  if (!finite(pose.eye) || !finite(pose.look_at) || !finite(pose.up)) {
    return base::Error{"a number of the camera is not finite", "camera", "give plain numbers"};
  }
  if (!(pose.vertical_fov_degrees >= 1.0 && pose.vertical_fov_degrees <= 179.0)) {
    return base::Error{"the field of view is out of range", "vertical_fov_degrees", "use 1 to 179 degrees"};
  }
  const ModelVector view = pose.look_at - pose.eye;
  if (!(length(view) > 0.0))
    return base::Error{"the camera stands where it looks", "eye", "move eye away from look_at"};
  Camera camera;
  camera.pose_ = pose;
  camera.viewport_ = viewport;
  camera.forward_ = normalized(view);
  const ModelVector side = glm::cross(camera.forward_, pose.up);
  if (!(length(side) > 1e-9 * length(pose.up))) {
    return base::Error{"up is parallel to the viewing direction", "up", "choose another up vector"};
  }
  camera.right_ = normalized(side);
  camera.up_ = glm::cross(camera.right_, camera.forward_);
  camera.half_height_ = base::tan(base::radians(pose.vertical_fov_degrees) * 0.5);
  return camera;
}

double Camera::depth(const ModelPoint& point) const { return glm::dot(point - pose_.eye, forward_); }

std::optional<PxPoint> Camera::project(const ModelPoint& point) const {
  const ModelVector d = point - pose_.eye;
  const double z = glm::dot(d, forward_);
  if (!(z > 0.0)) return std::nullopt;
  const double px_per_unit = viewport_.height * 0.5 / (half_height_ * z);
  return PxPoint{viewport_.width * 0.5 + glm::dot(d, right_) * px_per_unit,
                 viewport_.height * 0.5 - glm::dot(d, up_) * px_per_unit};
}

Ray Camera::ray(PxPoint position) const {
  const double unit = 2.0 * half_height_ / viewport_.height;
  const double x = (position.x - viewport_.width * 0.5) * unit;
  const double y = (viewport_.height * 0.5 - position.y) * unit;
  return {pose_.eye, normalized(forward_ + right_ * x + up_ * y, forward_)};
}

Camera frame_box(const Box& box, Viewport viewport, double yaw_degrees, double pitch_degrees,
                 double vertical_fov_degrees) {
  viewport = {std::max(1, viewport.width), std::max(1, viewport.height)};
  const auto or_else = [](double number, double other) { return std::isfinite(number) ? number : other; };
  yaw_degrees = or_else(yaw_degrees, 0);
  pitch_degrees = or_else(pitch_degrees, 0);
  vertical_fov_degrees = std::clamp(or_else(vertical_fov_degrees, 30), 1.0, 179.0);
  Box framed = box;
  // Boxes beyond these limits have no view whose numbers are finite and apart from each other.
  const double farthest = std::max(length(framed.minimum), length(framed.maximum));
  if (framed.empty() || !(farthest < 1e100)) framed = {ModelPoint{-0.5}, ModelPoint{0.5}};
  if (!(framed.diagonal() > std::max(1e-100, 1e-12 * farthest))) {
    const ModelPoint middle = framed.center();
    const double half = 0.5 * std::max(1.0, 1e-6 * length(middle));
    framed = {middle - half, middle + half};
  }
  const double yaw = base::radians(yaw_degrees);
  const double pitch = base::radians(std::clamp(pitch_degrees, -89.0, 89.0));
  const ModelVector back{base::sin(yaw) * base::cos(pitch), base::sin(pitch), base::cos(yaw) * base::cos(pitch)};
  const ModelVector right = normalized(glm::cross(ModelVector{0, 1, 0}, back));
  const ModelVector up = glm::cross(back, right);
  const double tan_y = base::tan(base::radians(vertical_fov_degrees) * 0.5);
  const double tan_x = tan_y * viewport.width / viewport.height;
  constexpr double k_fill = 10.0 / 12.0;
  // The eye stands as close as every corner of the box allows.
  double away = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const ModelPoint p{(corner & 1) != 0 ? framed.maximum.x : framed.minimum.x,
                       (corner & 2) != 0 ? framed.maximum.y : framed.minimum.y,
                       (corner & 4) != 0 ? framed.maximum.z : framed.minimum.z};
    const ModelVector d = p - framed.center();
    const double near = glm::dot(d, back);
    away = std::max({away, near + std::abs(glm::dot(d, right)) / (tan_x * k_fill),
                     near + std::abs(glm::dot(d, up)) / (tan_y * k_fill)});
  }
  CameraPose pose{framed.center() + back * away, framed.center(), {0, 1, 0}, vertical_fov_degrees};
  // Cannot fail: all numbers are finite, the eye is apart from the middle, and the pitch ends before the pole.
  return Camera::make(pose, viewport).value();
}

}  // namespace penpose::geometry
