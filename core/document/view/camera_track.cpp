#include "core/document/view/camera_track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"

namespace penpose::document {
namespace {

using geometry::CameraPose;
using geometry::ModelVector;

/// What of a camera goes on by itself.
struct Channels {
  enum : std::size_t { x, y, z, up_x, up_y, up_z, yaw, pitch, distance, angle, aspect, count };
  std::array<double, count> values{};
};

double half_tangent(const CameraPose& camera) { return base::tan(base::radians(camera.vertical_fov_degrees) * 0.5); }

double degrees_of(double half) { return std::clamp(2 * base::degrees(base::atan2(half, 1)), 1.0, 179.0); }

/// As large a picture by another angle, or, where no perspective is wanted or possible, from another distance.
CameraPose with_half_tangent(CameraPose camera, double half) {
  const double least = base::tan(base::radians(0.5));
  if (half >= least && half_tangent(camera) > least * (1 + 1e-9)) {
    camera.vertical_fov_degrees = degrees_of(half);
    return camera;
  }
  camera.eye = camera.look_at + (camera.eye - camera.look_at) * (half / least);
  camera.vertical_fov_degrees = 1;
  return camera;
}

Channels channels_of(const View& view) {
  const CameraPose& camera = view.camera;
  const ModelVector back = camera.eye - camera.look_at;
  const double flat = std::sqrt(back.x * back.x + back.z * back.z);
  // Sizes go on by ratios: as much larger in each moment.
  return {{camera.look_at.x, camera.look_at.y, camera.look_at.z, camera.up.x, camera.up.y, camera.up.z,
           base::atan2(back.x, back.z), base::atan2(back.y, flat), base::log(geometry::length(back)),
           base::log(half_tangent(camera)),
           base::log(static_cast<double>(view.viewport.width) / view.viewport.height)}};
}

FramedCamera framed_of(const Channels& channels) {
  const auto& at = channels.values;
  FramedCamera framed;
  const double flat = base::cos(at[Channels::pitch]);
  const ModelVector back{base::sin(at[Channels::yaw]) * flat, base::sin(at[Channels::pitch]),
                         base::cos(at[Channels::yaw]) * flat};
  framed.camera.look_at = {at[Channels::x], at[Channels::y], at[Channels::z]};
  framed.camera.eye = framed.camera.look_at + back * base::exp(at[Channels::distance]);
  framed.camera.up = {at[Channels::up_x], at[Channels::up_y], at[Channels::up_z]};
  framed.camera.vertical_fov_degrees = degrees_of(base::exp(at[Channels::angle]));
  framed.aspect = base::exp(at[Channels::aspect]);
  return framed;
}

FramedCamera framed_of(const View& view) {
  return {view.camera, static_cast<double>(view.viewport.width) / view.viewport.height};
}

/// The turn that comes nearest to another one, by whole turns.
double nearest_turn(double yaw, double other) {
  constexpr double k_turn = 2 * base::k_pi;
  return yaw - k_turn * std::floor((yaw - other) / k_turn + 0.5);
}

/// The keys around a segment: before it, its ends, behind it. A key that is not there is the end itself.
struct Around {
  std::array<const CameraKey*, 4> keys{};
  std::array<Channels, 4> channels{};
};

Around around(const CameraTrack& track, std::size_t place) {
  const std::size_t last = track.keys.size() - 1;
  const std::array<std::size_t, 4> places{place > 0 ? place - 1 : place, place, place + 1, std::min(place + 2, last)};
  Around out;
  for (std::size_t i = 0; i < places.size(); ++i) {
    out.keys.at(i) = &track.keys[places.at(i)];
    out.channels.at(i) = channels_of(out.keys.at(i)->view);
  }
  const auto yaw = [&](std::size_t i) -> double& { return out.channels.at(i).values[Channels::yaw]; };
  yaw(0) = nearest_turn(yaw(0), yaw(1));
  yaw(2) = nearest_turn(yaw(2), yaw(1));
  yaw(3) = nearest_turn(yaw(3), yaw(2));
  return out;
}

/// The slope of a smooth key in the middle of three; flat at the ends of the track.
double slope_of(const Around& near, std::size_t key, std::size_t channel) {
  const auto secant = [&](std::size_t a, std::size_t b) {
    return (near.channels.at(b).values.at(channel) - near.channels.at(a).values.at(channel)) /
           (near.keys.at(b)->time_s - near.keys.at(a)->time_s);
  };
  const bool ends = near.keys.at(key - 1) == near.keys.at(key) || near.keys.at(key) == near.keys.at(key + 1);
  return ends ? 0 : monotone_slope(secant(key - 1, key), secant(key, key + 1));
}

}  // namespace

std::optional<FramedCamera> camera_at(const CameraTrack& track, double time_s) {
  const auto& keys = track.keys;
  if (keys.empty()) return std::nullopt;
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), time_s, [](double t, const CameraKey& key) { return t < key.time_s; });
  // At a key and outside of all the view is the key's own, bit for bit.
  if (after == keys.begin()) return framed_of(keys.front().view);
  const CameraKey& before = *(after - 1);
  if (after == keys.end() || before.time_s == time_s || before.kind == KeyKind::stepped) return framed_of(before.view);
  const auto place = static_cast<std::size_t>(after - keys.begin()) - 1;
  const Around near = around(track, place);
  Channels now;
  for (std::size_t i = 0; i < Channels::count; ++i) {
    KeySegment segment{before.time_s, after->time_s, near.channels[1].values.at(i), near.channels[2].values.at(i)};
    segment.kind = before.kind;
    segment.slope_from = slope_of(near, 1, i);
    segment.slope_to = slope_of(near, 2, i);
    now.values.at(i) = value_at(segment, time_s);
  }
  const FramedCamera between = framed_of(now);
  const bool sees = geometry::Camera::make(between.camera, {1000, 1000}).ok();
  return sees ? between : framed_of(before.view);
}

View view_of_part(const View& whole, const PartOfPicture& part) {
  View view = whole;
  const geometry::PxPoint size = part.to - part.from;
  view.viewport = {std::max(1, static_cast<int>(std::round(size.x))),
                   std::max(1, static_cast<int>(std::round(size.y)))};
  const auto camera = geometry::Camera::make(whole.camera, whole.viewport);
  if (!camera || !(size.x > 0) || !(size.y > 0)) return view;
  const geometry::PxPoint middle = (part.from + part.to) * 0.5;
  const double unit = camera->units_per_px(camera->depth(whole.camera.look_at));
  const ModelVector aside = camera->right() * ((middle.x - 0.5 * whole.viewport.width) * unit) -
                            camera->up() * ((middle.y - 0.5 * whole.viewport.height) * unit);
  view.camera.eye += aside;
  view.camera.look_at += aside;
  view.camera = with_half_tangent(view.camera, half_tangent(whole.camera) * size.y / whole.viewport.height);
  return view;
}

CameraPose camera_of_whole(const FramedCamera& framed, geometry::Viewport whole, const PartOfPicture& part) {
  CameraPose camera = framed.camera;
  const geometry::PxPoint size = part.to - part.from;
  if (!(size.x > 0) || !(size.y > 0)) return camera;
  const double wider = std::max(1.0, framed.aspect * size.y / size.x);
  camera = with_half_tangent(camera, half_tangent(camera) * wider * whole.height / size.y);
  const auto seen = geometry::Camera::make(camera, whole);
  if (!seen) return framed.camera;
  const geometry::PxPoint middle = (part.from + part.to) * 0.5;
  const double unit = seen->units_per_px(seen->depth(camera.look_at));
  const ModelVector aside =
      seen->right() * ((middle.x - 0.5 * whole.width) * unit) - seen->up() * ((middle.y - 0.5 * whole.height) * unit);
  camera.eye -= aside;
  camera.look_at -= aside;
  return camera;
}

}  // namespace penpose::document
