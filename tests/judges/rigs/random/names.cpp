#include "tests/judges/rigs/random/names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "tests/judges/rigs/control_words.h"

namespace penpose::judges {
namespace {

struct Word {
  const char* muscle;
  const char* words;
  const char* plain;
  const char* facs;
};

constexpr std::array<Word, 35> k_words{{
    {"smile_", "mouthSmile", "smile", "AU12"},
    {"frown_", "mouthFrown", "mouth_sad", "AU15"},
    {"stretch_", "mouthStretch", "mouth_wide", "AU20"},
    {"dimple_", "mouthDimple", "dimple", "AU14"},
    {"press_", "mouthPress", "lips_thin", "AU24"},
    {"upper_up_", "mouthUpperUp", "lip_raise", "AU10"},
    {"lower_down_", "mouthLowerDown", "lip_drop", "AU16"},
    {"cheek_", "cheekSquint", "cheek_up", "AU6"},
    {"puff_", "cheekPuff", "puff", "AU33"},
    {"sneer_", "noseSneer", "nose_wrinkle", "AU9"},
    {"brow_inner_up_", "browInnerUp", "brow_sad", "AU1"},
    {"brow_outer_up_", "browOuterUp", "brow_arch", "AU2"},
    {"brow_down_", "browDown", "brow_angry", "AU4"},
    {"brow_up_", "browUp", "brow_raise", "AU1_2"},
    {"brow_mid_up_", "browMidUp", "brow_mid", "AU1m"},
    {"blink_", "eyeBlink", "close_eye", "AU43"},
    {"wide_", "eyeWide", "open_eye", "AU5"},
    {"squint_", "eyeSquint", "lid_low", "AU7"},
    {"look_up_", "eyeLookUp", "look_up", "AU63"},
    {"look_down_", "eyeLookDown", "look_down", "AU64"},
    {"look_left_", "eyeLookAtLeft", "look_left", "AU61"},
    {"look_right_", "eyeLookAtRight", "look_right", "AU62"},
    {"pucker", "mouthPucker", "kiss", "AU18"},
    {"funnel", "mouthFunnel", "oo", "AU22"},
    {"jaw_open", "jawOpen", "open", "AU26"},
    {"jaw_forward", "jawForward", "chin_out", "AU29"},
    {"jaw_L", "jawLeft", "chin_left", "AU30L"},
    {"jaw_R", "jawRight", "chin_right", "AU30R"},
    {"mouth_L", "mouthLeft", "mouth_shift_left", "M_L"},
    {"mouth_R", "mouthRight", "mouth_shift_right", "M_R"},
    {"roll_upper", "mouthRollUpper", "lip_in_upper", "AU28u"},
    {"roll_lower", "mouthRollLower", "lip_in_lower", "AU28l"},
    {"shrug_upper", "mouthShrugUpper", "lip_out_upper", "AU17u"},
    {"shrug_lower", "mouthShrugLower", "chin_up", "AU17"},
    {"lips_close", "mouthClose", "seal", "AU8"},
}};

}  // namespace

Names::Names(Dice dice) {
  using Strings = std::vector<std::string>;
  constexpr std::array<Style, 8> k_styles{Style::words, Style::words,           Style::words,           Style::plain,
                                          Style::plain, Style::numbers_of_facs, Style::numbers_of_facs, Style::numbers};
  style_ = dice.one_of(k_styles);
  before_ = dice.one_of(Strings{"", "", "", "", "face_", "bs.", "Head_blendShape.", "c_"});
  before_joint_ = dice.one_of(Strings{"", "", "c_", "DEF-", "jnt_", "mixamo:"});
  const std::array<std::pair<const char*, const char*>, 8> sides{{{"_L", "_R"},
                                                                  {"_L", "_R"},
                                                                  {"Left", "Right"},
                                                                  {".L", ".R"},
                                                                  {"_left", "_right"},
                                                                  {"_l", "_r"},
                                                                  {" left", " right"},
                                                                  {"_R", "_L"}}};
  // The last are of makers who say the sides as they see them.
  const auto& [left, right] = sides[dice.chance(0.06) ? 7 : dice.below(7)];
  left_ = left;
  right_ = right;
  side_first_ = dice.chance(0.12);
}

std::string Names::sided(const std::string& name, const std::string& word) const {
  if (!has_side(word)) return name;
  const std::string& end = word.ends_with("_L") ? left_ : right_;
  return side_first_ ? std::string(1, end[end.size() == 2 ? 1 : end.find_first_not_of("_ ")]) + "_" + name : name + end;
}

std::string Names::unique(std::string name) {
  std::string given = name;
  for (std::size_t k = 2; has(taken_, given); ++k) given = name + "_" + std::to_string(k);
  taken_.push_back(given);
  return given;
}

std::string Names::control(const std::string& word) {
  if (style_ == Style::numbers) return before_ + "shape" + std::to_string(++numbered_);
  const auto known = std::find_if(k_words.begin(), k_words.end(),
                                  [&](const Word& w) { return w.muscle == word || w.muscle == without_side(word); });
  if (known == k_words.end()) {
    const std::string plain = is_paired(word) ? word.substr(0, word.size() - 2) : word;
    return before_ + (is_paired(word) ? sided(plain, word) : plain);
  }
  const char* name = style_ == Style::words ? known->words : style_ == Style::plain ? known->plain : known->facs;
  return before_ + (is_paired(word) ? sided(name, word) : name);
}

std::string Names::joint(const std::string& word) {
  const std::string plain = has_side(word) ? word.substr(0, word.size() - 2) : word;
  return unique(before_joint_ + sided(plain, word));
}

}  // namespace penpose::judges
