#include "tests/judges/rigs/bones.h"
#include "tests/judges/rigs/held_out/held_out_rigs.h"

namespace penpose::judges {

Rig make_face_bones() {
  const Parts& parts = head_parts();
  FaceBuilder face("face_bones", "a face that joints alone move", Group::held_out, parts);
  const auto head = static_cast<std::int32_t>(add_head_bones(face, parts));
  for (const std::string side : {"L", "R"}) {
    const double out = side == "L" ? 1 : -1;
    const auto bone = [&](const std::string& name, const std::string& muscle, const geometry::ModelPoint& at) {
      face.carry(face.joint(name + side, head, at, 40), share_of(parts.field(muscle + side)));
      return name + side;
    };
    const geometry::ModelPoint middle{0, 0.01, -0.02};
    const std::string inner = bone("brow_inner_", "brow_inner_up_", middle);
    face.turn_means(inner + ".rx", -0.1, {"brow_inner_up_" + side});
    face.turn_means(inner + ".rx", 0.1, {"brow_down_" + side});
    face.turn_means(bone("brow_outer_", "brow_outer_up_", middle) + ".rx", -0.1, {"brow_outer_up_" + side});
    const std::string corner = bone("mouth_corner_", "smile_", {out * 0.015, -0.06, -0.01});
    face.turn_means(corner + ".rx", -0.12, {"smile_" + side});
    face.turn_means(corner + ".rx", 0.12, {"frown_" + side});
    face.turn_means(corner + ".ry", out * 0.1, {"stretch_" + side});
    const auto& ball = parts.eyes.at(side);
    geometry::Box box;
    for (const std::uint32_t v : ball) box.add(parts.rest()[v]);
    const std::string lid = bone("lid_", "blink_", box.center());
    face.turn_means(lid + ".rx", 0.5, {"blink_" + side});
    face.turn_means(lid + ".rx", -0.2, {"wide_" + side});
  }
  return face.build();
}

Rig make_quadruped() {
  tests::StickFigure beast;
  beast.add(-1, {0, 0.8, -0.5}, {0, 0.82, -0.2}, 0.16);
  beast.add(0, {0, 0.82, -0.2}, {0, 0.84, 0.1}, 0.17);
  beast.add(1, {0, 0.84, 0.1}, {0, 0.86, 0.4}, 0.16);
  beast.add(2, {0, 0.9, 0.45}, {0, 1.1, 0.62}, 0.09);
  beast.add(3, {0, 1.1, 0.62}, {0, 1.08, 0.9}, 0.08);
  const auto leg = [&](std::int32_t body, double x, double z) {
    const auto top = static_cast<std::int32_t>(beast.add(body, {x, 0.75, z}, {x, 0.42, z - 0.04}, 0.07));
    const auto low = static_cast<std::int32_t>(beast.add(top, {x, 0.42, z - 0.04}, {x, 0.1, z + 0.03}, 0.05));
    beast.add(low, {x, 0.1, z + 0.03}, {x, 0.03, z + 0.1}, 0.04);
  };
  leg(2, 0.12, 0.35);
  leg(2, -0.12, 0.35);
  leg(0, 0.12, -0.45);
  leg(0, -0.12, -0.45);
  std::int32_t tail = 0;
  for (int k = 0; k < 4; ++k)
    tail = static_cast<std::int32_t>(
        beast.add(tail, {0, 0.84 - 0.03 * k, -0.62 - 0.12 * k}, {0, 0.81 - 0.03 * k, -0.74 - 0.12 * k}, 0.035));
  return limb_rig(
      "quadruped", "a beast of tubes with four legs, a neck and a tail", Group::held_out, beast,
      {{"foreleg_forward", 90, {5, 6, 7}, {{5, {-35, 0, 0}}}},
       {"foreleg_bent", 90, {5, 6, 7}, {{5, {-40, 0, 0}}, {6, {50, 0, 0}}}},
       {"hindleg_back", 90, {11, 12, 13}, {{11, {30, 0, 0}}}},
       {"hindleg_knee", 90, {11, 12, 13}, {{12, {35, 0, 0}}}},
       {"other_foreleg", -90, {8, 9, 10}, {{8, {-30, 0, 0}}}},
       {"neck_lowered", 90, {3, 4}, {{3, {40, 0, 0}}}},
       {"nod", 90, {4}, {{4, {25, 0, 0}}}},
       {"tail_up", 90, {17, 18, 19, 20}, {{17, {15, 0, 0}}, {18, {15, 0, 0}}, {19, {15, 0, 0}}, {20, {15, 0, 0}}}}});
}

}  // namespace penpose::judges
