#include "core/document/humanoid.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/rig/control_names.h"

namespace penpose::document {
namespace {

struct Bone {
  std::string_view name;
  int parent;
};
constexpr std::array<Bone, k_human_bones> k_bones{{{"hips", -1},
                                                   {"spine", 0},
                                                   {"chest", 1},
                                                   {"upperChest", 2},
                                                   {"neck", 3},
                                                   {"head", 4},
                                                   {"leftEye", 5},
                                                   {"rightEye", 5},
                                                   {"jaw", 5},
                                                   {"leftUpperLeg", 0},
                                                   {"leftLowerLeg", 9},
                                                   {"leftFoot", 10},
                                                   {"leftToes", 11},
                                                   {"rightUpperLeg", 0},
                                                   {"rightLowerLeg", 13},
                                                   {"rightFoot", 14},
                                                   {"rightToes", 15},
                                                   {"leftShoulder", 3},
                                                   {"leftUpperArm", 17},
                                                   {"leftLowerArm", 18},
                                                   {"leftHand", 19},
                                                   {"rightShoulder", 3},
                                                   {"rightUpperArm", 21},
                                                   {"rightLowerArm", 22},
                                                   {"rightHand", 23},
                                                   {"leftThumbMetacarpal", 20},
                                                   {"leftThumbProximal", 25},
                                                   {"leftThumbDistal", 26},
                                                   {"leftIndexProximal", 20},
                                                   {"leftIndexIntermediate", 28},
                                                   {"leftIndexDistal", 29},
                                                   {"leftMiddleProximal", 20},
                                                   {"leftMiddleIntermediate", 31},
                                                   {"leftMiddleDistal", 32},
                                                   {"leftRingProximal", 20},
                                                   {"leftRingIntermediate", 34},
                                                   {"leftRingDistal", 35},
                                                   {"leftLittleProximal", 20},
                                                   {"leftLittleIntermediate", 37},
                                                   {"leftLittleDistal", 38},
                                                   {"rightThumbMetacarpal", 24},
                                                   {"rightThumbProximal", 40},
                                                   {"rightThumbDistal", 41},
                                                   {"rightIndexProximal", 24},
                                                   {"rightIndexIntermediate", 43},
                                                   {"rightIndexDistal", 44},
                                                   {"rightMiddleProximal", 24},
                                                   {"rightMiddleIntermediate", 46},
                                                   {"rightMiddleDistal", 47},
                                                   {"rightRingProximal", 24},
                                                   {"rightRingIntermediate", 49},
                                                   {"rightRingDistal", 50},
                                                   {"rightLittleProximal", 24},
                                                   {"rightLittleIntermediate", 52},
                                                   {"rightLittleDistal", 53}}};

/// Words for bones of the middle and of one side, as folded names have them without the side.
using enum HumanBone;
constexpr std::pair<std::string_view, HumanBone> k_middle[] = {{"hips", hips},
                                                               {"hip", hips},
                                                               {"pelvis", hips},
                                                               {"spine", spine},
                                                               {"waist", spine},
                                                               {"chest", chest},
                                                               {"spine1", chest},
                                                               {"upperchest", upper_chest},
                                                               {"spine2", upper_chest},
                                                               {"neck", neck},
                                                               {"head", head},
                                                               {"jaw", jaw},
                                                               {"chin", jaw}};
/// Of the left side; the right one has the same order.
constexpr std::pair<std::string_view, HumanBone> k_sided[] = {{"eye", left_eye},
                                                              {"eyeball", left_eye},
                                                              {"faceeye", left_eye},
                                                              {"upperleg", left_upper_leg},
                                                              {"upleg", left_upper_leg},
                                                              {"thigh", left_upper_leg},
                                                              {"lowerleg", left_lower_leg},
                                                              {"leg", left_lower_leg},
                                                              {"calf", left_lower_leg},
                                                              {"shin", left_lower_leg},
                                                              {"knee", left_lower_leg},
                                                              {"foot", left_foot},
                                                              {"ankle", left_foot},
                                                              {"toes", left_toes},
                                                              {"toe", left_toes},
                                                              {"toebase", left_toes},
                                                              {"shoulder", left_shoulder},
                                                              {"clavicle", left_shoulder},
                                                              {"upperarm", left_upper_arm},
                                                              {"arm", left_upper_arm},
                                                              {"lowerarm", left_lower_arm},
                                                              {"forearm", left_lower_arm},
                                                              {"elbow", left_lower_arm},
                                                              {"hand", left_hand},
                                                              {"wrist", left_hand},
                                                              {"thumb1", left_thumb_metacarpal},
                                                              {"handthumb1", left_thumb_metacarpal},
                                                              {"thumb2", left_thumb_proximal},
                                                              {"handthumb2", left_thumb_proximal},
                                                              {"thumb3", left_thumb_distal},
                                                              {"handthumb3", left_thumb_distal},
                                                              {"index1", left_index_proximal},
                                                              {"handindex1", left_index_proximal},
                                                              {"index2", left_index_intermediate},
                                                              {"handindex2", left_index_intermediate},
                                                              {"index3", left_index_distal},
                                                              {"handindex3", left_index_distal},
                                                              {"middle1", left_middle_proximal},
                                                              {"handmiddle1", left_middle_proximal},
                                                              {"middle2", left_middle_intermediate},
                                                              {"handmiddle2", left_middle_intermediate},
                                                              {"middle3", left_middle_distal},
                                                              {"handmiddle3", left_middle_distal},
                                                              {"ring1", left_ring_proximal},
                                                              {"handring1", left_ring_proximal},
                                                              {"ring2", left_ring_intermediate},
                                                              {"handring2", left_ring_intermediate},
                                                              {"ring3", left_ring_distal},
                                                              {"handring3", left_ring_distal},
                                                              {"little1", left_little_proximal},
                                                              {"handlittle1", left_little_proximal},
                                                              {"pinky1", left_little_proximal},
                                                              {"handpinky1", left_little_proximal},
                                                              {"little2", left_little_intermediate},
                                                              {"handlittle2", left_little_intermediate},
                                                              {"pinky2", left_little_intermediate},
                                                              {"handpinky2", left_little_intermediate},
                                                              {"little3", left_little_distal},
                                                              {"handlittle3", left_little_distal},
                                                              {"pinky3", left_little_distal},
                                                              {"handpinky3", left_little_distal}};

/// The bone of the right side for one of the left.
HumanBone other_side(HumanBone bone) {
  std::string name(name_of(bone));
  name.replace(0, 4, "right");
  return *human_bone_named(name);
}

/// A name in words: digits and letters that belong together, in lower case, without "_" and changes of case between.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  bool open = false;
  char last = 0;
  for (const char c : name) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool lower = c >= 'a' && c <= 'z';
    const bool digit = c >= '0' && c <= '9';
    if (!upper && !lower && !digit) {
      open = false;
      continue;
    }
    const bool last_lower = last >= 'a' && last <= 'z';
    if (!open || (upper && last_lower)) words.emplace_back();
    open = true;
    words.back() += upper ? static_cast<char>(c - 'A' + 'a') : c;
    last = c;
  }
  return words;
}

std::optional<HumanBone> find_word(std::string_view word, char side) {
  if (side == 0) {
    for (const auto& [known, bone] : k_middle) {
      if (word == known) return bone;
    }
    return std::nullopt;
  }
  for (const auto& [known, bone] : k_sided) {
    if (word == known) return side == 'l' ? bone : other_side(bone);
  }
  return std::nullopt;
}

/// The bone that a joint's name says.
std::optional<HumanBone> bone_of(std::string_view name) {
  // A prefix of Mixamo's ends at the colon.
  if (const auto colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
  std::vector<std::string> words = words_of(name);
  if (words.size() == 1) {
    // VRM's own name, without a change of case.
    for (std::size_t i = 0; i < k_human_bones; ++i) {
      if (rig::folded_name(k_bones[i].name) == words[0]) return static_cast<HumanBone>(i);
    }
  }
  if (auto exact = human_bone_named(name)) return exact;
  // VRoid Studio: J_Bip_C_Head, J_Adj_L_FaceEye.
  if (words.size() > 3 && words[0] == "j" && (words[1] == "bip" || words[1] == "adj")) {
    words.erase(words.begin(), words.begin() + 2);
    if (words[0] == "c") words.erase(words.begin());
  }
  // 3ds Max: Bip01 L Hand; Unreal has no prefix.
  if (words.size() > 1 && (words[0].starts_with("bip") || words[0] == "mixamorig" || words[0] == "def")) {
    words.erase(words.begin());
  }
  char side = 0;
  std::string word;
  for (const std::string& one : words) {
    const char says = one == "l" || one == "left" ? 'l' : one == "r" || one == "right" ? 'r' : '\0';
    if (says != 0 && side != 0) return std::nullopt;
    if (says != 0) {
      side = says;
    } else {
      // Digits of finger bones are written 01 too.
      const bool number = one.size() == 2 && one[0] == '0' && one[1] >= '0' && one[1] <= '9';
      word += number ? one.substr(1) : one;
    }
  }
  return find_word(word, side);
}

}  // namespace

std::string_view name_of(HumanBone bone) { return k_bones[static_cast<std::size_t>(bone)].name; }

std::optional<HumanBone> human_bone_named(std::string_view name) {
  for (std::size_t i = 0; i < k_human_bones; ++i) {
    if (k_bones[i].name == name) return static_cast<HumanBone>(i);
  }
  return std::nullopt;
}

std::optional<HumanBone> human_bone_named_in_vrm0(std::string_view name) {
  if (name == "leftThumbProximal") return left_thumb_metacarpal;
  if (name == "leftThumbIntermediate") return left_thumb_proximal;
  if (name == "rightThumbProximal") return right_thumb_metacarpal;
  if (name == "rightThumbIntermediate") return right_thumb_proximal;
  return human_bone_named(name);
}

std::optional<HumanBone> parent_of(HumanBone bone) {
  const int parent = k_bones[static_cast<std::size_t>(bone)].parent;
  return parent < 0 ? std::nullopt : std::optional(static_cast<HumanBone>(parent));
}

bool Humanoid::empty() const {
  return std::all_of(joint_of.begin(), joint_of.end(), [](std::int32_t joint) { return joint < 0; });
}

Humanoid humanoid_by_names(std::span<const rig::Joint> joints) {
  Humanoid result;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto bone = bone_of(joints[i].name);
    // Parents come first.
    if (bone && !result.joint(*bone)) result.joint_of[static_cast<std::size_t>(*bone)] = static_cast<std::int32_t>(i);
  }
  return result;
}

}  // namespace penpose::document
