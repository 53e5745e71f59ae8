#include "tests/judges/rigs/seen/seen_rigs.h"
#include "tests/judges/rigs/sets.h"

namespace penpose::judges {

Rig make_split() {
  FaceBuilder face("split", "a shape for each side of each muscle", Group::seen, head_parts());
  add_brows(face);
  add_lids(face);
  add_mouth(face);
  return face.build();
}

Rig make_summed() {
  const Parts parts = reshaped(head_parts(), broad_person);
  FaceBuilder face("summed", "both sides in one shape, sums of them, and their parts", Group::seen, parts);
  face.shape("smile", {{"smile_L", 1}, {"smile_R", 1}, {"cheek_L", 0.6}, {"cheek_R", 0.6}},
             Means{"smile_L", "smile_R"});
  face.shape("corners_up", {{"smile_L", 0.9}, {"smile_R", 0.9}});
  face.shape("cheeks", {{"cheek_L", 1}, {"cheek_R", 1}});
  face.shape("frown", {{"frown_L", 1}, {"frown_R", 1}, {"shrug_lower", 0.3}});
  face.shape("mouth_open", {{"jaw_open", 0.8}, {"lower_down_L", 0.2}, {"lower_down_R", 0.2}});
  face.shape("wide", {{"stretch_L", 1}, {"stretch_R", 1}});
  face.shape("pucker", {{"pucker", 1}});
  face.shape("brows_up",
             {{"brow_inner_up_L", 1}, {"brow_inner_up_R", 1}, {"brow_outer_up_L", 1}, {"brow_outer_up_R", 1}});
  face.shape("brows_worried", {{"brow_inner_up_L", 1}, {"brow_inner_up_R", 1}});
  face.shape("brows_down", {{"brow_down_L", 1}, {"brow_down_R", 1}});
  face.shape("blink", {{"blink_L", 1}, {"blink_R", 1}});
  face.shape("wink_L", {{"blink_L", 1}});
  face.shape("wink_R", {{"blink_R", 1}});
  face.shape("eyes_wide", {{"wide_L", 1}, {"wide_R", 1}});
  face.shape("sneer", {{"sneer_L", 1}, {"sneer_R", 1}});
  face.emote(
      "joy",
      {{"smile_L", 0.9}, {"smile_R", 0.9}, {"cheek_L", 0.7}, {"cheek_R", 0.7}, {"squint_L", 0.6}, {"squint_R", 0.6}});
  face.emote("sorrow", {{"frown_L", 0.7}, {"frown_R", 0.7}, {"brow_inner_up_L", 0.8}, {"brow_inner_up_R", 0.8}});
  face.emote("rage", {{"brow_down_L", 1},
                      {"brow_down_R", 1},
                      {"sneer_L", 0.6},
                      {"sneer_R", 0.6},
                      {"stretch_L", 0.4},
                      {"stretch_R", 0.4}});
  return face.build();
}

Rig make_one_sided() {
  const Parts parts = reshaped(head_parts(), broad_person);
  FaceBuilder face("one_sided", "shapes of one side without a partner, and shapes of both", Group::seen, parts);
  face.shape("smile", {{"smile_L", 1}, {"smile_R", 1}});
  face.shape("smile_left", {{"smile_L", 1}});
  face.shape("frown_left", {{"frown_L", 1}});
  face.shape("frown_right", {{"frown_R", 1}});
  face.shape("stretch_right", {{"stretch_R", 1}});
  face.shape("jaw_open", {{"jaw_open", 1}});
  face.shape("pucker", {{"pucker", 1}});
  face.shape("mouth_left", {{"mouth_L", 1}});
  face.shape("brows_up",
             {{"brow_inner_up_L", 1}, {"brow_inner_up_R", 1}, {"brow_outer_up_L", 1}, {"brow_outer_up_R", 1}});
  face.shape("brow_up_right", {{"brow_inner_up_R", 1}, {"brow_outer_up_R", 1}});
  face.shape("brow_down_left", {{"brow_down_L", 1}});
  face.shape("brow_down_right", {{"brow_down_R", 1}});
  face.shape("eyes_closed", {{"blink_L", 1}, {"blink_R", 1}});
  face.shape("wink_left", {{"blink_L", 1}, {"cheek_L", 0.4}});
  face.shape("sneer_right", {{"sneer_R", 1}});
  return face.build();
}

Rig make_weak() {
  FaceBuilder face("weak", "shapes that move little at their most, and ordinary ones", Group::seen, head_parts());
  face.sides("browUp", {{"brow_inner_up_", 0.3}, {"brow_outer_up_", 0.3}});
  face.sides("browDown", {{"brow_down_", 0.3}});
  add_lids(face);
  face.shape("smile", {{"smile_L", 0.25}, {"smile_R", 0.25}});
  face.sides("frown", {{"frown_", 0.25}});
  face.shape("jawOpen", {{"jaw_open", 0.35}});
  face.shape("pucker", {{"pucker", 0.5}});
  face.shape("funnel", {{"funnel", 1}});
  face.sides("stretch", {{"stretch_", 0.4}});
  face.shape("mouthLeft", {{"mouth_L", 0.3}});
  face.shape("mouthRight", {{"mouth_R", 0.3}});
  return face.build();
}

Rig make_no_brows() {
  FaceBuilder face("no_brows", "nothing moves the brows", Group::seen, head_parts());
  add_lids(face);
  add_mouth(face);
  return face.build();
}

Rig make_emotes() {
  FaceBuilder face("emotes", "whole faces that include what single shapes do", Group::seen, head_parts());
  add_brows(face);
  face.sides("eyeBlink", {{"blink_", 1}});
  face.sides("eyeWide", {{"wide_", 1}});
  face.sides("mouthSmile", {{"smile_", 1}});
  face.sides("mouthFrown", {{"frown_", 1}});
  face.shape("open_mouth", {{"jaw_open", 0.9}, {"pucker", 0.3}});
  face.shape("ooh", {{"pucker", 0.85}, {"jaw_open", 0.2}});
  face.emote("kiss", {{"pucker", 1}, {"blink_L", 0.9}, {"blink_R", 0.9}});
  face.emote("surprise", {{"jaw_open", 0.55},
                          {"brow_inner_up_L", 0.7},
                          {"brow_inner_up_R", 0.7},
                          {"brow_outer_up_L", 0.7},
                          {"brow_outer_up_R", 0.7},
                          {"wide_L", 0.8},
                          {"wide_R", 0.8}});
  face.emote("delight", {{"smile_L", 0.9}, {"smile_R", 0.9}, {"jaw_open", 0.4}, {"squint_L", 0.7}, {"squint_R", 0.7}});
  return face.build();
}

}  // namespace penpose::judges
