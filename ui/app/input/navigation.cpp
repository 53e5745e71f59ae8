#include "ui/app/input/navigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penpose::app {
namespace {

constexpr double k_degrees = 180.0 / std::numbers::pi;
constexpr double k_steepest = 89.0;
/// The middle may come this near and go this far, in diagonals of the model.
constexpr double k_nearest = 0.02;
constexpr double k_farthest = 20.0;

geometry::CameraPose moved(geometry::CameraPose camera, const geometry::ModelVector& by) {
  camera.eye += by;
  camera.look_at += by;
  return camera;
}

/// Of the picture at distance 1.
double half_height(const geometry::CameraPose& camera) {
  return std::tan(0.5 * camera.vertical_fov_degrees / k_degrees);
}

double distance_of(const geometry::CameraPose& camera) { return geometry::distance(camera.eye, camera.look_at); }

}  // namespace

render::Viewpoint viewpoint_of(const geometry::CameraPose& camera) {
  const geometry::ModelVector back = geometry::normalized(camera.eye - camera.look_at);
  return {std::atan2(back.x, back.z) * k_degrees, std::asin(std::clamp(back.y, -1.0, 1.0)) * k_degrees};
}

geometry::CameraPose orbited(const geometry::CameraPose& camera, double yaw, double pitch) {
  const render::Viewpoint from = viewpoint_of(camera);
  const double around = (from.yaw_degrees + yaw) / k_degrees;
  const double above = std::clamp(from.pitch_degrees + pitch, -k_steepest, k_steepest) / k_degrees;
  const double away = distance_of(camera);
  geometry::CameraPose turned = camera;
  turned.up = {0, 1, 0};
  turned.eye = camera.look_at + geometry::ModelVector{std::sin(around) * std::cos(above), std::sin(above),
                                                      std::cos(around) * std::cos(above)} *
                                    away;
  return turned;
}

geometry::CameraPose panned(const document::View& view, PxPoint by) {
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return view.camera;
  const double unit = camera->units_per_px(distance_of(view.camera));
  return moved(view.camera, camera->right() * (-by.x * unit) + camera->up() * (by.y * unit));
}

geometry::CameraPose zoomed(const document::View& view, double factor, PxPoint about, double size) {
  const double before = distance_of(view.camera);
  // The narrower the field of view, the farther away is the same size.
  geometry::CameraPose usual = view.camera;
  usual.vertical_fov_degrees = k_usual_degrees;
  const double reach = size * half_height(usual) / half_height(view.camera);
  const double after = std::clamp(before * factor, k_nearest * reach, std::max(before, k_farthest * reach));
  geometry::CameraPose nearer = view.camera;
  nearer.eye = view.camera.look_at + (view.camera.eye - view.camera.look_at) * (after / before);
  const PxPoint from_middle{about.x - 0.5 * view.viewport.width, about.y - 0.5 * view.viewport.height};
  return panned({nearer, view.viewport}, from_middle * (1.0 - before / after));
}

geometry::CameraPose with_field_of_view(const geometry::CameraPose& camera, double degrees) {
  geometry::CameraPose other = camera;
  other.vertical_fov_degrees = degrees;
  other.eye = camera.look_at + (camera.eye - camera.look_at) * (half_height(camera) / half_height(other));
  return other;
}

geometry::CameraPose seen_from(const document::View& view, const render::Viewpoint& from, PxPoint about) {
  const PxPoint to_middle{0.5 * view.viewport.width - about.x, 0.5 * view.viewport.height - about.y};
  const geometry::CameraPose middle = panned(view, to_middle);
  const render::Viewpoint now = viewpoint_of(middle);
  const auto turned = orbited(middle, from.yaw_degrees - now.yaw_degrees, from.pitch_degrees - now.pitch_degrees);
  return panned({turned, view.viewport}, to_middle * -1.0);
}

document::View framed(std::span<const glm::vec3> points, geometry::Viewport window, const Area& free,
                      const render::Viewpoint& from) {
  const geometry::Viewport seen{std::max(1, static_cast<int>(free.width())),
                                std::max(1, static_cast<int>(free.height()))};
  document::View view{render::frame_points(points, seen, from).pose(), window};
  const double away = static_cast<double>(window.height) / seen.height;
  view.camera.eye = view.camera.look_at + (view.camera.eye - view.camera.look_at) * away;
  const PxPoint middle = free.middle();
  view.camera = panned(view, {middle.x - 0.5 * window.width, middle.y - 0.5 * window.height});
  return view;
}

}  // namespace penpose::app
