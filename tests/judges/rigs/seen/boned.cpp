#include "tests/judges/rigs/bones.h"
#include "tests/judges/rigs/seen/seen_rigs.h"

namespace penpose::judges {

Rig make_jaw_bone() {
  const Parts& parts = head_parts();
  FaceBuilder face("jaw_bone", "joints of neck, jaw and eyes, and shapes", Group::seen, parts);
  add_head_bones(face, parts);
  add_brows(face);
  add_lids(face);
  face.sides("mouthSmile", {{"smile_", 1}});
  face.sides("mouthFrown", {{"frown_", 1}});
  face.sides("mouthStretch", {{"stretch_", 1}});
  face.shape("mouthPucker", {{"pucker", 1}});
  face.shape("mouthFunnel", {{"funnel", 1}});
  face.sides("noseSneer", {{"sneer_", 1}});
  return face.build();
}

Rig make_walker() {
  return limb_rig("walker", "a figure of tubes that stands, joints in frames of their own", Group::seen,
                  tests::stick_man(),
                  {{"arm_raised", 0, {6, 7, 8}, {{6, {0, 0, 45}}}},
                   {"arm_lowered", 0, {6, 7, 8}, {{6, {0, 0, -50}}}},
                   {"elbow_bent", 0, {7, 8}, {{7, {0, 0, 55}}}},
                   {"arm_bent", 0, {6, 7, 8}, {{6, {0, 0, -30}}, {7, {0, 0, 40}}}},
                   {"other_arm", 0, {12, 13, 14}, {{12, {0, 0, -40}}}},
                   {"leg_aside", 0, {9, 10, 11}, {{9, {0, 0, 25}}}},
                   {"leg_forward", 90, {9, 10, 11}, {{9, {-35, 0, 0}}}},
                   {"knee_bent", 90, {9, 10, 11}, {{9, {-40, 0, 0}}, {10, {45, 0, 0}}}},
                   {"bow", 90, {1, 2, 3, 4, 5}, {{1, {8, 0, 0}}, {2, {8, 0, 0}}, {3, {8, 0, 0}}, {4, {8, 0, 0}}}},
                   {"nod", 90, {4, 5}, {{5, {25, 0, 0}}}}});
}

Rig make_trunk() {
  tests::StickFigure trunk;
  trunk.add(-1, {0, 0, 0}, {0.3, 0, 0}, 0.12);
  for (int k = 0; k < 7; ++k) trunk.add(k, {0.3 + 0.15 * k, 0, 0}, {0.45 + 0.15 * k, 0, 0}, 0.1 - 0.01 * k);
  const auto curl = [](double first, double each) {
    std::vector<Move::Turn> turns;
    for (std::size_t j = 1; j < 8; ++j) turns.push_back({j, {0, 0, j == 1 ? first : each}});
    return turns;
  };
  return limb_rig("trunk", "one limb of eight joints that bend alike", Group::seen, trunk,
                  {{"up", 0, {1, 2, 3, 4, 5, 6, 7}, curl(10, 10)},
                   {"curled", 0, {1, 2, 3, 4, 5, 6, 7}, curl(14, 18)},
                   {"down", 0, {1, 2, 3, 4, 5, 6, 7}, curl(-12, -12)},
                   {"at_root", 0, {1, 2, 3, 4, 5, 6, 7}, {{1, {0, 0, 35}}}},
                   {"tip_up", 0, {4, 5, 6, 7}, {{4, {0, 0, 15}}, {5, {0, 0, 15}}, {6, {0, 0, 15}}, {7, {0, 0, 15}}}}});
}

}  // namespace penpose::judges
