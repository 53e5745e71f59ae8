#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/math.h"
#include "core/character/demo_head.h"
#include "core/head/head.h"
#include "core/rig/rig.h"
#include "tests/judges/rigs/sculpt.h"

namespace penpose::judges {
namespace {

std::vector<FaceLine> lines_of(const document::Model& head) {
  std::vector<FaceLine> lines;
  for (const document::NamedCurve& curve : head.curves) {
    FaceLine line{curve.name, {}};
    for (const mesh::MeshPoint& p : curve.points) {
      const auto most = std::max_element(p.barycentric.begin(), p.barycentric.end()) - p.barycentric.begin();
      const std::uint32_t v = head.mesh->triangles()[p.triangle][static_cast<std::size_t>(most)];
      // Points between vertices may be nearest to one and the same.
      if (std::find(line.vertices.begin(), line.vertices.end(), v) == line.vertices.end()) line.vertices.push_back(v);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// What one of the program's own controls does at an end of its range.
Field control_field(const document::Model& head, const std::string& name, bool at_most) {
  rig::Pose pose = rig::rest_pose(*head.rig);
  const std::size_t i = rig::find_parameter(head.rig->parameters(), name).value();
  pose[i] = at_most ? head.rig->parameters()[i].maximum : head.rig->parameters()[i].minimum;
  Field field(head.mesh->vertex_count());
  head.rig->evaluate(pose, field);
  for (std::size_t v = 0; v < field.size(); ++v) field[v] -= head.mesh->positions()[v];
  return field;
}

void add_eyes(Parts& parts, const document::Model& head) {
  for (const bool left : {true, false}) {
    const std::string side = left ? "_L" : "_R";
    std::vector<double> ball(parts.rest().size(), 0);
    for (const char* piece : {"eye", "iris_rim", "iris", "pupil"}) {
      const mesh::Part& part = *head.mesh->find_part(piece + side);
      for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
        ball[v] = 1;
        parts.eyes[side.substr(1)].push_back(v);
      }
    }
    const head::HeadLandmarks eyes = head::head_landmarks();
    const ModelPoint center = left ? eyes.left.center : eyes.right.center;
    const auto look = [&](const ModelVector& axis, double degrees) {
      return turned(parts.rest(), ball, center, axis, degrees);
    };
    // Lids go along with the gaze.
    parts.fields["look_up" + side] = look({1, 0, 0}, -18);
    add_to(parts.fields["look_up" + side], 0.5, parts.field("wide" + side));
    parts.fields["look_down" + side] = look({1, 0, 0}, 22);
    add_to(parts.fields["look_down" + side], 0.4, parts.field("blink" + side));
    parts.fields["look_left" + side] = look({0, 1, 0}, 25);
    parts.fields["look_right" + side] = look({0, 1, 0}, -25);
  }
}

Parts made_head() {
  const document::Model head = character::make_demo_head().value();
  Parts parts;
  parts.mesh = head.mesh;
  parts.lines = lines_of(head);
  const auto& lip = parts.line("lip_upper");
  parts.mouth = 0.5 * geometry::distance(parts.rest()[lip.front()], parts.rest()[lip.back()]);

  const Field jaw = control_field(head, "jaw", true);
  double most = 0;
  for (const ModelVector& d : jaw) most = std::max(most, geometry::length(d));
  for (const ModelVector& d : jaw) parts.jaw_share.push_back(smooth_step(0.1, 0.5, geometry::length(d) / most));
  parts.fields["jaw_open"] = jaw;
  parts.fields["pucker"] = control_field(head, "lips_pucker", true);
  const Field lip_up = control_field(head, "lip_upper", true);
  const Field wrinkle = control_field(head, "nose_wrinkle", true);
  for (const bool left : {true, false}) {
    const std::string side = left ? "_L" : "_R";
    const auto half = side_share(parts.rest(), left, 0.3 * parts.mouth);
    parts.fields["upper_up" + side] = times(lip_up, half);
    parts.fields["sneer" + side] = times(wrinkle, half);
    parts.fields["smile" + side] = control_field(head, "mouth_corner" + side, true);
    parts.fields["frown" + side] = control_field(head, "mouth_frown" + side, true);
    parts.fields["cheek" + side] = control_field(head, "cheek" + side, true);
    parts.fields["blink" + side] = control_field(head, "eyelid_upper" + side, true);
    parts.fields["wide" + side] = control_field(head, "eyelid_upper" + side, false);
    parts.fields["squint" + side] = control_field(head, "eyelid_lower" + side, true);
    parts.fields["brow_inner_up" + side] = control_field(head, "brow_inner" + side, true);
    parts.fields["brow_outer_up" + side] = control_field(head, "brow_outer" + side, true);
    // A frown draws the brows together, too.
    Field down = control_field(head, "brow_inner" + side, false);
    add_to(down, 0.4, control_field(head, "brow_outer" + side, false));
    const ModelPoint inner = parts.rest()[parts.line("brow" + side).front()];
    const ModelVector together{(left ? -0.16 : 0.16) * parts.mouth, 0, 0};
    add_to(down, 1, pushed(around(parts.rest(), inner, ModelVector{0.6, 0.5, 0.8} * parts.mouth), together));
    parts.fields["brow_down" + side] = std::move(down);
  }
  add_mouth_fields(parts);
  add_eyes(parts, head);
  return parts;
}

}  // namespace

const Parts& head_parts() {
  static const Parts parts = made_head();
  return parts;
}

}  // namespace penpose::judges
