#include "tests/judges/rigs/sets.h"

#include <algorithm>

namespace penpose::judges {

void add_brows(FaceBuilder& face) {
  face.sides("browInnerUp", {{"brow_inner_up_", 1}});
  face.sides("browOuterUp", {{"brow_outer_up_", 1}});
  face.sides("browDown", {{"brow_down_", 1}});
}

void add_lids(FaceBuilder& face) {
  face.sides("eyeBlink", {{"blink_", 1}, {"squint_", 0.2}});
  face.sides("eyeWide", {{"wide_", 1}});
  face.sides("eyeSquint", {{"squint_", 1}});
  face.sides("cheekSquint", {{"cheek_", 1}, {"squint_", 0.4}});
}

void add_mouth(FaceBuilder& face) {
  face.shape("jawOpen", {{"jaw_open", 1}});
  face.sides("mouthSmile", {{"smile_", 1}, {"cheek_", 0.25}});
  face.sides("mouthFrown", {{"frown_", 1}});
  face.sides("mouthStretch", {{"stretch_", 1}});
  face.shape("mouthPucker", {{"pucker", 1}});
  face.shape("mouthFunnel", {{"funnel", 1}});
  face.sides("mouthUpperUp", {{"upper_up_", 1}});
  face.sides("mouthLowerDown", {{"lower_down_", 1}});
  face.shape("mouthLeft", {{"mouth_L", 1}});
  face.shape("mouthRight", {{"mouth_R", 1}});
  face.sides("noseSneer", {{"sneer_", 1}});
}

void add_arkit(FaceBuilder& face) {
  const auto sides = [&](const char* name, const Recipe& recipe) { face.sides(name, "Left", "Right", "", recipe); };
  sides("eyeBlink", {{"blink_", 1}, {"squint_", 0.15}});
  sides("eyeLookDown", {{"look_down_", 1}});
  // In is towards the nose.
  face.shape("eyeLookInLeft", {{"look_right_L", 1}});
  face.shape("eyeLookInRight", {{"look_left_R", 1}});
  face.shape("eyeLookOutLeft", {{"look_left_L", 1}});
  face.shape("eyeLookOutRight", {{"look_right_R", 1}});
  sides("eyeLookUp", {{"look_up_", 1}});
  sides("eyeSquint", {{"squint_", 1}});
  sides("eyeWide", {{"wide_", 1}});
  face.shape("jawForward", {{"jaw_forward", 1}});
  face.shape("jawLeft", {{"jaw_L", 1}});
  face.shape("jawRight", {{"jaw_R", 1}});
  face.shape("jawOpen", {{"jaw_open", 1}});
  face.shape("mouthClose", {{"lips_close", 1}});
  face.shape("mouthFunnel", {{"funnel", 1}});
  face.shape("mouthPucker", {{"pucker", 1}});
  face.shape("mouthLeft", {{"mouth_L", 1}});
  face.shape("mouthRight", {{"mouth_R", 1}});
  sides("mouthSmile", {{"smile_", 1}, {"cheek_", 0.2}});
  sides("mouthFrown", {{"frown_", 1}});
  sides("mouthDimple", {{"dimple_", 1}});
  sides("mouthStretch", {{"stretch_", 1}});
  face.shape("mouthRollLower", {{"roll_lower", 1}});
  face.shape("mouthRollUpper", {{"roll_upper", 1}});
  face.shape("mouthShrugLower", {{"shrug_lower", 1}});
  face.shape("mouthShrugUpper", {{"shrug_upper", 1}});
  sides("mouthPress", {{"press_", 1}});
  sides("mouthLowerDown", {{"lower_down_", 1}});
  sides("mouthUpperUp", {{"upper_up_", 1}});
  sides("browDown", {{"brow_down_", 1}});
  face.shape("browInnerUp", {{"brow_inner_up_L", 1}, {"brow_inner_up_R", 1}});
  sides("browOuterUp", {{"brow_outer_up_", 1}});
  face.shape("cheekPuff", {{"puff_L", 1}, {"puff_R", 1}});
  sides("cheekSquint", {{"cheek_", 1}, {"squint_", 0.3}});
  sides("noseSneer", {{"sneer_", 1}, {"upper_up_", 0.2}});
}

void add_visemes(FaceBuilder& face, const std::string& before) {
  const Means nothing;
  face.shape(before + "aa", {{"jaw_open", 0.8}, {"lower_down_L", 0.2}, {"lower_down_R", 0.2}});
  face.shape(before + "E", {{"stretch_L", 0.6}, {"stretch_R", 0.6}, {"jaw_open", 0.25}},
             Means{"stretch_L", "stretch_R"});
  face.shape(before + "ih", {{"stretch_L", 0.4}, {"stretch_R", 0.4}, {"jaw_open", 0.15}}, nothing);
  face.shape(before + "oh", {{"funnel", 0.7}, {"jaw_open", 0.35}}, Means{"funnel"});
  face.shape(before + "ou", {{"pucker", 0.85}, {"jaw_open", 0.12}}, Means{"pucker"});
  face.shape(before + "PP", {{"press_L", 0.8}, {"press_R", 0.8}, {"roll_upper", 0.4}, {"roll_lower", 0.4}}, nothing);
  face.shape(before + "FF", {{"roll_lower", 0.8}, {"upper_up_L", 0.25}, {"upper_up_R", 0.25}}, nothing);
  face.shape(before + "TH", {{"jaw_open", 0.2}, {"lower_down_L", 0.2}, {"lower_down_R", 0.2}}, nothing);
  face.shape(before + "DD", {{"jaw_open", 0.15}, {"upper_up_L", 0.2}, {"upper_up_R", 0.2}}, nothing);
  face.shape(before + "kk", {{"jaw_open", 0.25}, {"stretch_L", 0.15}, {"stretch_R", 0.15}}, nothing);
  face.shape(before + "CH", {{"funnel", 0.6}, {"pucker", 0.2}}, Means{"funnel"});
  face.shape(before + "SS", {{"stretch_L", 0.35}, {"stretch_R", 0.35}, {"lower_down_L", 0.2}, {"lower_down_R", 0.2}},
             nothing);
  face.shape(before + "nn", {{"jaw_open", 0.1}, {"upper_up_L", 0.15}, {"upper_up_R", 0.15}}, nothing);
  face.shape(before + "RR", {{"funnel", 0.35}, {"jaw_open", 0.1}}, nothing);
}

std::vector<double> share_of(const Field& field) {
  double most = 0;
  for (const auto& d : field) most = std::max(most, geometry::length(d));
  std::vector<double> share;
  for (const auto& d : field) share.push_back(geometry::length(d) / most);
  return share;
}

}  // namespace penpose::judges
