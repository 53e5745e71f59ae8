#include "tests/judges/rigs/held_out/held_out_rigs.h"
#include "tests/judges/rigs/sets.h"

namespace penpose::judges {

Rig make_facs() {
  const Parts parts = reshaped(head_parts(), other_person);
  FaceBuilder face("facs", "action units by their numbers, another person", Group::held_out, parts);
  const auto sides = [&](const char* unit, const Recipe& recipe) { face.sides(unit, "_l", "_r", "", recipe); };
  sides("AU01", {{"brow_inner_up_", 1}});
  sides("AU02", {{"brow_outer_up_", 1}});
  sides("AU04", {{"brow_down_", 1}});
  sides("AU05", {{"wide_", 1}});
  sides("AU06", {{"cheek_", 1}, {"squint_", 0.4}});
  sides("AU07", {{"squint_", 1}});
  sides("AU09", {{"sneer_", 1}});
  sides("AU10", {{"upper_up_", 1}});
  sides("AU12", {{"smile_", 1}});
  sides("AU14", {{"dimple_", 1}});
  sides("AU15", {{"frown_", 1}});
  sides("AU16", {{"lower_down_", 1}});
  face.shape("AU17", {{"shrug_lower", 1}});
  face.shape("AU18", {{"pucker", 1}});
  sides("AU20", {{"stretch_", 1}});
  face.shape("AU22", {{"funnel", 1}});
  face.shape("AU23", {{"press_L", 1}, {"press_R", 1}});
  face.shape("AU26", {{"jaw_open", 0.5}});
  face.shape("AU27", {{"jaw_open", 1}, {"lower_down_L", 0.2}, {"lower_down_R", 0.2}});
  face.shape("AU28", {{"roll_upper", 1}, {"roll_lower", 1}});
  face.shape("AU30_l", {{"jaw_L", 1}});
  face.shape("AU30_r", {{"jaw_R", 1}});
  sides("AU43", {{"blink_", 1}});
  return face.build();
}

Rig make_creature() {
  const Parts parts = creature_parts();
  FaceBuilder face("creature", "a muzzle of a few hundred vertices", Group::held_out, parts);
  add_brows(face);
  add_lids(face);
  add_mouth(face);
  return face.build();
}

Rig make_doubles() {
  const Parts parts = reshaped(head_parts(), broad_person);
  FaceBuilder face("doubles", "the same shapes under two and three names", Group::held_out, parts);
  add_brows(face);
  add_lids(face);
  add_mouth(face);
  face.sides("old_smile_", "l", "r", "", {{"smile_", 1}, {"cheek_", 0.25}});
  face.sides("old_frown_", "l", "r", "", {{"frown_", 1}});
  face.sides("blink.", "left", "right", "", {{"blink_", 1}, {"squint_", 0.2}});
  face.sides("eyesClosed", {{"blink_", 0.95}, {"squint_", 0.2}});
  face.shape("open", {{"jaw_open", 0.9}});
  face.shape("kiss", {{"pucker", 0.95}});
  face.sides("browRaise", {{"brow_outer_up_", 1}});
  face.sides("browLower", {{"brow_down_", 0.9}});
  return face.build();
}

Rig make_correctives() {
  const Parts parts = reshaped(head_parts(), other_person);
  FaceBuilder face("correctives", "ARKit's names, and small corrections of pairs of shapes, which nobody draws",
                   Group::held_out, parts);
  add_arkit(face);
  const Means nothing;
  face.sides("fix_jawOpen_mouthSmile", {{"smile_", 0.25}, {"lower_down_", -0.2}, {"dimple_", 0.2}});
  for (const char* side : {"_L", "_R"}) {
    const std::string s = side;
    face.shape("fix_smile_frown" + s, {{"smile" + s, -0.2}, {"stretch" + s, 0.2}}, nothing);
    face.shape("fix_blink_squint" + s, {{"blink" + s, -0.15}, {"squint" + s, 0.15}}, nothing);
    face.shape("fix_brow_up_down" + s, {{"brow_outer_up" + s, 0.2}, {"brow_down" + s, 0.2}}, nothing);
    face.shape("fix_smile_sneer" + s, {{"cheek" + s, 0.3}, {"sneer" + s, 0.2}}, nothing);
  }
  face.shape("fix_jawOpen_pucker", {{"pucker", 0.25}, {"lips_close", 0.2}}, nothing);
  face.shape("fix_jawOpen_funnel", {{"funnel", 0.2}, {"lips_close", 0.15}}, nothing);
  return face.build();
}

Rig make_expressions() {
  const Parts parts = reshaped(head_parts(), toon);
  FaceBuilder face("expressions", "an avatar of whole expressions, mouths and blinks alone", Group::held_out, parts);
  face.shape("A", {{"jaw_open", 0.8}});
  face.shape("I", {{"stretch_L", 0.7}, {"stretch_R", 0.7}});
  face.shape("U", {{"pucker", 0.9}});
  face.shape("E", {{"stretch_L", 0.4}, {"stretch_R", 0.4}, {"jaw_open", 0.3}}, Means{});
  face.shape("O", {{"funnel", 0.7}, {"jaw_open", 0.4}}, Means{"funnel"});
  face.shape("Blink", {{"blink_L", 1}, {"blink_R", 1}});
  face.shape("Blink_L", {{"blink_L", 1}});
  face.shape("Blink_R", {{"blink_R", 1}});
  face.emote(
      "Joy",
      {{"smile_L", 0.9}, {"smile_R", 0.9}, {"cheek_L", 0.6}, {"cheek_R", 0.6}, {"squint_L", 0.5}, {"squint_R", 0.5}});
  face.emote("Angry", {{"brow_down_L", 1}, {"brow_down_R", 1}, {"frown_L", 0.6}, {"frown_R", 0.6}});
  face.emote("Sorrow", {{"brow_inner_up_L", 0.9},
                        {"brow_inner_up_R", 0.9},
                        {"frown_L", 0.6},
                        {"frown_R", 0.6},
                        {"blink_L", 0.2},
                        {"blink_R", 0.2}});
  face.emote(
      "Fun",
      {{"smile_L", 0.5}, {"smile_R", 0.5}, {"jaw_open", 0.3}, {"brow_outer_up_L", 0.4}, {"brow_outer_up_R", 0.4}});
  face.emote("Surprised", {{"wide_L", 1},
                           {"wide_R", 1},
                           {"brow_inner_up_L", 0.8},
                           {"brow_inner_up_R", 0.8},
                           {"brow_outer_up_L", 0.8},
                           {"brow_outer_up_R", 0.8},
                           {"funnel", 0.4},
                           {"jaw_open", 0.3}});
  return face.build();
}

}  // namespace penpose::judges
