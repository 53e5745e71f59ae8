#include "ui/app/widgets/picture_frame.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

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

/// Of a model whose names say nothing of a face.
PictureFrame usual_frame(const document::Model& model, const std::vector<ModelPoint>& rest) {
  std::vector<ModelPoint> face;
  for (const std::uint32_t vertex : render::face_vertices(model)) face.push_back(rest[vertex]);
  if (!face.empty()) return around(box_of(face), 0.02);
  const Box all = box_of(rest);
  return all.empty() ? PictureFrame{} : around(all, 0.03);
}

}  // namespace

PictureFrames picture_frames(const document::Model& model) {
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
  return frames;
}

}  // namespace penpose::app
