#include <array>

#include "tests/judges/rigs/seen/seen_rigs.h"
#include "tests/judges/rigs/sets.h"

namespace penpose::judges {

Rig make_toon() {
  const Parts parts = reshaped(head_parts(), toon);
  FaceBuilder face("toon", "large eyes and a small mouth; VRM's names, both sides in one shape", Group::seen, parts);
  face.shape("Fcl_MTH_A", {{"jaw_open", 0.8}});
  face.shape("Fcl_MTH_I", {{"stretch_L", 0.7}, {"stretch_R", 0.7}, {"jaw_open", 0.1}});
  face.shape("Fcl_MTH_U", {{"pucker", 0.9}, {"jaw_open", 0.1}});
  face.shape("Fcl_MTH_O", {{"funnel", 0.7}, {"jaw_open", 0.3}}, Means{"funnel"});
  face.shape("Fcl_MTH_Joy", {{"smile_L", 1}, {"smile_R", 1}, {"jaw_open", 0.2}});
  face.shape("Fcl_MTH_Angry", {{"frown_L", 1}, {"frown_R", 1}});
  face.shape("Fcl_BRW_Angry", {{"brow_down_L", 1}, {"brow_down_R", 1}});
  face.shape("Fcl_BRW_Sorrow", {{"brow_inner_up_L", 1}, {"brow_inner_up_R", 1}});
  face.shape("Fcl_BRW_Surprised",
             {{"brow_inner_up_L", 1}, {"brow_inner_up_R", 1}, {"brow_outer_up_L", 1}, {"brow_outer_up_R", 1}});
  face.shape("Fcl_EYE_Close", {{"blink_L", 1}, {"blink_R", 1}});
  face.shape("Fcl_EYE_Close_L", {{"blink_L", 1}});
  face.shape("Fcl_EYE_Close_R", {{"blink_R", 1}});
  face.shape("Fcl_EYE_Surprised", {{"wide_L", 1}, {"wide_R", 1}});
  face.shape("Fcl_EYE_Joy", {{"blink_L", 0.8}, {"blink_R", 0.8}, {"squint_L", 0.8}, {"squint_R", 0.8}}, Means{});
  face.emote("Fcl_ALL_Joy", {{"smile_L", 0.9},
                             {"smile_R", 0.9},
                             {"jaw_open", 0.3},
                             {"blink_L", 0.6},
                             {"blink_R", 0.6},
                             {"squint_L", 0.7},
                             {"squint_R", 0.7}});
  return face.build();
}

Rig make_arkit() {
  const Parts parts = reshaped(head_parts(), broad_person);
  FaceBuilder face("arkit", "ARKit's names", Group::seen, parts);
  add_arkit(face);
  return face.build();
}

Rig make_visemes() {
  FaceBuilder face("visemes", "mouths of speech, and a few shapes of the face", Group::seen, head_parts());
  add_visemes(face, "viseme_");
  add_brows(face);
  face.sides("eyeBlink", {{"blink_", 1}});
  face.sides("mouthSmile", {{"smile_", 1}});
  face.sides("mouthFrown", {{"frown_", 1}});
  return face.build();
}

Rig make_many() {
  FaceBuilder face("many", "over 150 controls: muscles, their halves, and sums of any two", Group::seen, head_parts());
  add_arkit(face);
  const std::array<const char*, 8> pairs{"smile",      "frown", "stretch", "upper_up",
                                         "lower_down", "sneer", "cheek",   "dimple"};
  for (std::size_t a = 0; a < pairs.size(); ++a) {
    for (std::size_t b = a + 1; b < pairs.size(); ++b) {
      for (const char* side : {"_L", "_R"}) {
        const std::string first = pairs[a] + std::string(side);
        const std::string second = pairs[b] + std::string(side);
        face.shape("sum_" + first + "_" + pairs[b], {{first, 0.6}, {second, 0.6}}, Means{});
      }
    }
  }
  for (const char* muscle : {"smile_", "frown_", "stretch_", "brow_inner_up_", "brow_outer_up_", "brow_down_"}) {
    for (const char* with : {"jaw_open", "pucker", "funnel", "mouth_L"}) {
      for (const char* side : {"L", "R"}) {
        const std::string first = muscle + std::string(side);
        face.shape("sum_" + first + "_" + with, {{first, 0.5}, {with, 0.5}}, Means{});
      }
    }
  }
  return face.build();
}

}  // namespace penpose::judges
