#include "ui/app/widgets/picture_frame.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"
#include "core/base/text/letters.h"
#include "ui/render/framing.h"

namespace penpose::app {
namespace {

using geometry::Box;
using geometry::ModelPoint;

/// A vertex is where a control works if it moves by this share of the most that the control moves any.
constexpr double k_much = 0.7;
/// Room around a part, and around a face, whose parts end at the brows and the chin: shares of the picture.
constexpr double k_around_part = 0.12, k_around_face = 0.22;
/// Room around what differs, a share of the picture; a vertex counts that goes so much of the longest way.
constexpr double k_around_difference = 0.16, k_differs_much = 0.5;
/// A picture of what differs is no smaller than this share of one of the face.
constexpr double k_least_of_face = 0.3;
/// The eye is so many sides of a face away, as in the canvas.
constexpr double k_sides_away = 2.35;
constexpr double k_yaw_step = 5, k_most_yaw = 75, k_most_pitch = 40;

std::vector<ModelPoint> posed(const rig::Rig& rig, const rig::Pose& pose) {
  std::vector<ModelPoint> positions(rig.vertex_count());
  rig.evaluate(pose, positions);
  return positions;
}

/// Where at rest a control works; empty: nowhere.
Box place_of_control(const rig::Rig& rig, std::size_t control, const std::vector<ModelPoint>& rest) {
  const rig::Parameter& parameter = rig.parameters()[control];
  rig::Pose pose = rig::rest_pose(rig);
  const bool down = parameter.rest - parameter.minimum > parameter.maximum - parameter.rest;
  pose[control] = down ? parameter.minimum : parameter.maximum;
  const auto moved = posed(rig, pose);
  double most = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) most = std::max(most, geometry::distance(moved[i], rest[i]));
  Box box;
  for (std::size_t i = 0; most > 0 && i < rest.size(); ++i) {
    if (geometry::distance(moved[i], rest[i]) > k_much * most) box.add(rest[i]);
  }
  return box;
}

PictureFrame around(const Box& box, double room) {
  const ModelPoint size = box.maximum - box.minimum;
  return {box.center(), std::max({1e-9, size.x, size.y}) / (1 - 2 * room)};
}

Box box_of(const std::vector<ModelPoint>& points) {
  Box box;
  for (const ModelPoint& p : points) box.add(p);
  return box;
}

/// Controls of the lips move little else, whereas the jaw's take the cheeks and the throat along.
bool is_of_lips(std::string_view name) {
  const std::string text = base::lower_case(name);
  return text.find("mouth") != std::string::npos || text.find("lip") != std::string::npos;
}

/// With room below for an opened mouth.
PictureFrame around_lips(const Box& box) {
  PictureFrame frame = around(box, 0.15);
  frame.middle.y -= 0.15 * frame.side;
  return frame;
}

PictureFrame smaller(const PictureFrame& a, const PictureFrame& b) { return a.side < b.side ? a : b; }

/// The directions of a picture: to its right, up, and towards the eye.
struct Axes {
  geometry::ModelVector right, up, near;
  [[nodiscard]] ModelPoint seen(const ModelPoint& p) const {
    return {glm::dot(p, right), glm::dot(p, up), glm::dot(p, near)};
  }
  [[nodiscard]] ModelPoint from_seen(const ModelPoint& p) const { return right * p.x + up * p.y + near * p.z; }
};
Axes axes_of(const document::Model& model, double yaw_degrees, double pitch_degrees) {
  const double yaw = base::radians(model.front_yaw_degrees + yaw_degrees);
  const double pitch = base::radians(pitch_degrees);
  const geometry::ModelVector right{base::cos(yaw), 0, -base::sin(yaw)};
  const geometry::ModelVector near{base::sin(yaw) * base::cos(pitch), base::sin(pitch),
                                   base::cos(yaw) * base::cos(pitch)};
  return {right, glm::cross(near, right), near};
}

/// By the curves of the features that were found; `frames` where they say nothing.
void frame_features(const document::Model& model, std::span<const portrait::FeatureCurve> features,
                    const std::vector<ModelPoint>& rest, PictureFrames& frames) {
  const Axes axes = axes_of(model, 0, 0);
  std::array<Box, 4> parts;
  Box lips;
  for (const portrait::FeatureCurve& curve : features) {
    const auto part = poses::part_of_feature(curve.name);
    if (!part) continue;
    for (const posing::CurvePoint& point : curve.points) {
      const ModelPoint at = axes.seen(rest[portrait::nearest_vertex(point)]);
      parts[static_cast<std::size_t>(*part)].add(at);
      if (is_of_lips(curve.name)) lips.add(at);
    }
  }
  const auto box_of_part = [&](FacePart part) -> Box& { return parts[static_cast<std::size_t>(part)]; };
  // The line of the jaw goes up to the ears.
  if (!lips.empty()) box_of_part(FacePart::mouth) = lips;
  if (lips.empty() || box_of_part(FacePart::eyes).empty()) return;
  Box& face = box_of_part(FacePart::all);
  const auto set = [&](FacePart part, PictureFrame frame) {
    frame.middle = axes.from_seen(frame.middle);
    frames[static_cast<std::size_t>(part)] = frame;
  };
  for (const FacePart part : {FacePart::brows, FacePart::eyes, FacePart::mouth}) {
    const Box& box = box_of_part(part);
    if (box.empty()) continue;
    face.add(box.minimum);
    face.add(box.maximum);
    set(part, part == FacePart::mouth ? around_lips(box) : around(box, k_around_part));
  }
  set(FacePart::all, around(face, k_around_face));
}

/// Of a model whose names say nothing of a face.
PictureFrame usual_frame(const document::Model& model, const std::vector<ModelPoint>& rest) {
  std::vector<ModelPoint> face;
  for (const std::uint32_t vertex : render::face_vertices(model)) face.push_back(rest[vertex]);
  if (!face.empty()) return around(box_of(face), 0.02);
  const Box all = box_of(rest);
  return all.empty() ? PictureFrame{} : around(all, 0.03);
}

}  // namespace

PictureFrames picture_frames(const document::Model& model, std::span<const portrait::FeatureCurve> features) {
  const rig::Rig& rig = *model.rig;
  const auto rest = posed(rig, rig::rest_pose(rig));
  std::array<Box, 4> parts;
  const auto at = [](FacePart part) { return static_cast<std::size_t>(part); };
  Box lips;
  const double whole = box_of(rest).diagonal();
  const auto parameters = rig.parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const FacePart part = part_of(parameters[i].name);
    if (part == FacePart::all) continue;
    const Box box = place_of_control(rig, i, rest);
    // What moves half of the model is no part of a face, whatever it is called.
    if (box.empty() || box.diagonal() > 0.5 * whole) continue;
    for (const ModelPoint& corner : {box.minimum, box.maximum}) {
      if (part == FacePart::mouth && is_of_lips(parameters[i].name)) lips.add(corner);
      parts[at(part)].add(corner);
      parts[at(FacePart::all)].add(corner);
    }
  }
  PictureFrames frames;
  const bool known = !parts[at(FacePart::all)].empty();
  frames[at(FacePart::all)] = known ? around(parts[at(FacePart::all)], k_around_face) : usual_frame(model, rest);
  for (const FacePart part : {FacePart::brows, FacePart::eyes, FacePart::mouth}) {
    const Box& box = parts[at(part)];
    frames[at(part)] = box.empty() ? frames[at(FacePart::all)] : around(box, k_around_part);
  }
  if (!lips.empty()) frames[at(FacePart::mouth)] = smaller(frames[at(FacePart::mouth)], around_lips(lips));
  frame_features(model, features, rest, frames);
  for (PictureFrame& frame : frames) frame.away = k_sides_away * frames[0].side;
  return frames;
}

PictureFrame frame_of_differences(const document::Model& model, const rig::Pose& pose,
                                  std::span<const rig::Pose> others, const PictureFrame& face) {
  const std::vector<ModelPoint> now = posed(*model.rig, pose);
  const Axes axes = axes_of(model, face.yaw_degrees, face.pitch_degrees);
  double most = 0;
  std::vector<std::vector<ModelPoint>> then;
  for (const rig::Pose& other : others) {
    then.push_back(posed(*model.rig, other));
    for (std::size_t v = 0; v < now.size(); ++v) most = std::max(most, geometry::distance(now[v], then.back()[v]));
  }
  Box box;
  for (const auto& places : then) {
    for (std::size_t v = 0; most > 0 && v < now.size(); ++v) {
      if (geometry::distance(now[v], places[v]) < k_differs_much * most) continue;
      box.add(axes.seen(now[v]));
      box.add(axes.seen(places[v]));
    }
  }
  if (box.empty()) return face;
  PictureFrame frame = face;
  const PictureFrame about = around(box, k_around_difference);
  if (about.side >= face.side) return face;
  frame.side = std::max(about.side, k_least_of_face * face.side);
  frame.middle = axes.from_seen(about.middle);
  return frame;
}

geometry::CameraPose camera_of_frame(const document::Model& model, const PictureFrame& frame) {
  const Axes axes = axes_of(model, frame.yaw_degrees, frame.pitch_degrees);
  const double away = frame.away > 0 ? frame.away : k_sides_away * frame.side;
  const double half_degrees = base::degrees(std::atan(0.5 * frame.side / away));
  return {frame.middle + axes.near * away, frame.middle, {0, 1, 0}, std::clamp(2 * half_degrees, 1.0, 170.0)};
}

PictureFrame seen_from(const document::Model& model, PictureFrame frame, const geometry::CameraPose& camera) {
  const geometry::ModelVector to = geometry::normalized(camera.eye - camera.look_at);
  const auto stepped = [](double degrees, double most) {
    return std::clamp(k_yaw_step * std::round(degrees / k_yaw_step), -most, most);
  };
  const double yaw = base::degrees(std::atan2(to.x, to.z)) - model.front_yaw_degrees;
  frame.yaw_degrees = stepped(std::remainder(yaw, 360.0), k_most_yaw);
  frame.pitch_degrees = stepped(base::degrees(std::asin(std::clamp(to.y, -1.0, 1.0))), k_most_pitch);
  return frame;
}

}  // namespace penpose::app
