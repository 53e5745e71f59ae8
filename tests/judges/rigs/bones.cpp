#include "tests/judges/rigs/bones.h"

#include <algorithm>
#include <utility>

#include "tests/judges/rigs/sculpt.h"

namespace penpose::judges {

std::size_t add_head_bones(FaceBuilder& face, const Parts& parts) {
  const std::vector<double> all(parts.rest().size(), 1.0);
  double low = 1e300;
  for (const ModelPoint& p : parts.rest()) low = std::min(low, p.y);
  const std::size_t root = face.joint("root", -1, {0, low - 0.1, 0});
  const std::size_t neck = face.joint("neck", static_cast<std::int32_t>(root), {0, low, 0});
  const std::size_t head = face.joint("head", static_cast<std::int32_t>(neck), {0, low + 0.05, 0});
  face.carry(neck, all);
  std::vector<double> above;
  for (const ModelPoint& p : parts.rest()) above.push_back(smooth_step(low + 0.01, low + 0.07, p.y));
  face.carry(head, above);
  const std::size_t jaw = face.joint("jaw", static_cast<std::int32_t>(head), {0, -0.035, 0.01}, 25);
  face.carry(jaw, parts.jaw_share);
  face.turn_means("jaw.rx", 0.3, {"jaw_open"});
  for (const auto& [side, ball] : parts.eyes) {
    std::vector<double> share(parts.rest().size(), 0.0);
    geometry::Box box;
    for (const std::uint32_t v : ball) {
      share[v] = 1;
      box.add(parts.rest()[v]);
    }
    face.carry(face.joint("eye_" + side, static_cast<std::int32_t>(head), box.center(), 35), share);
  }
  return head;
}

Rig limb_rig(std::string name, std::string kind, Group group, const tests::StickFigure& figure,
             std::vector<Move> moves) {
  Rig rig;
  rig.name = std::move(name);
  rig.kind = std::move(kind);
  rig.group = group;
  rig.moves = std::move(moves);
  const auto made = figure.rig();
  mesh::MeshSource source;
  source.positions.assign(made->mesh().positions().begin(), made->mesh().positions().end());
  source.triangles.assign(made->mesh().triangles().begin(), made->mesh().triangles().end());
  rig.model =
      document::make_model(mesh::TriangleMesh::build(std::move(source)).value(), nullptr, figure.skeleton()).value();
  return rig;
}

}  // namespace penpose::judges
