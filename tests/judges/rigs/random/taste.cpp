#include "tests/judges/rigs/random/taste.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penpose::judges {
namespace {

struct Spill {
  const char* from;
  const char* onto;
  double most;
};

constexpr std::array k_spills{
    Spill{"smile_", "cheek_", 0.5},
    Spill{"smile_", "squint_", 0.3},
    Spill{"smile_", "dimple_", 0.3},
    Spill{"smile_", "stretch_", 1.0},
    Spill{"smile_", "upper_up_", 0.5},
    Spill{"frown_", "shrug_lower", 0.4},
    Spill{"frown_", "lower_down_", 0.25},
    Spill{"frown_", "stretch_", 0.6},
    Spill{"brow_inner_up_", "brow_outer_up_", 0.3},
    Spill{"brow_inner_up_", "wide_", 0.15},
    Spill{"brow_outer_up_", "wide_", 0.2},
    Spill{"brow_outer_up_", "brow_inner_up_", 0.3},
    Spill{"brow_down_", "squint_", 0.25},
    Spill{"brow_down_", "sneer_", 0.3},
    Spill{"brow_down_", "blink_", 0.12},
    Spill{"pucker", "shrug_lower", 0.45},
    Spill{"pucker", "funnel", 0.3},
    Spill{"pucker", "jaw_open", 0.2},
    Spill{"pucker", "jaw_forward", 0.3},
    Spill{"funnel", "pucker", 0.3},
    Spill{"funnel", "jaw_open", 0.2},
    Spill{"blink_", "squint_", 0.4},
    Spill{"blink_", "cheek_", 0.15},
    Spill{"blink_", "brow_down_", 0.1},
    Spill{"wide_", "brow_outer_up_", 0.2},
    Spill{"jaw_open", "lower_down_", 0.4},
    Spill{"jaw_open", "frown_", 0.8},
    Spill{"jaw_open", "pucker", 0.4},
    Spill{"upper_up_", "sneer_", 0.35},
    Spill{"sneer_", "upper_up_", 0.4},
    Spill{"sneer_", "brow_down_", 0.2},
    Spill{"sneer_", "smile_", 0.5},
    Spill{"stretch_", "frown_", 0.4},
    Spill{"stretch_", "smile_", 0.3},
    Spill{"pucker", "upper_up_", 0.3},
    Spill{"upper_up_", "smile_", 0.4},
    Spill{"lower_down_", "frown_", 0.4},
    Spill{"stretch_", "press_", 0.3},
    Spill{"mouth_L", "jaw_L", 0.35},
    Spill{"mouth_R", "jaw_R", 0.35},
    Spill{"lower_down_", "stretch_", 0.2},
    // What is meant for cheeks, a nose or the form of lips moves the mouth, too.
    Spill{"puff_", "pucker", 1.0},
    Spill{"puff_", "stretch_", -0.2},
    Spill{"dimple_", "smile_", 0.5},
    Spill{"dimple_", "upper_up_", 0.2},
    Spill{"cheek_", "upper_up_", 0.35},
    Spill{"cheek_", "smile_", 0.25},
    Spill{"press_", "shrug_lower", 0.4},
    Spill{"press_", "shrug_upper", -0.4},
    Spill{"press_", "stretch_", 0.25},
    Spill{"roll_upper", "shrug_upper", -0.5},
    Spill{"roll_lower", "shrug_lower", 0.5},
    Spill{"shrug_upper", "upper_up_", 0.3},
    Spill{"shrug_lower", "upper_up_", 0.25},
    Spill{"shrug_lower", "shrug_upper", 0.4},
};

}  // namespace

Taste::Taste(const Parts& parts, const Dice& dice) : parts_(parts), dice_(dice) {
  Dice own = dice.about("taste");
  spill_ = own.chance(0.25) ? 0 : own.real(0.3, 1);
  strength_ = own.chance(0.5) ? 0 : own.real(0.05, 0.4);
  lacks_ = own.chance(0.5) ? 0 : own.real(0, 0.25);
  weak_smiles_ = Dice(dice.about("weak smiles")).chance(0.2);
}

bool Taste::make(Recipe& recipe) const {
  if (recipe.empty()) return false;
  for (const auto& [muscle, amount] : recipe) {
    if (!parts_.fields.contains(muscle)) return false;
  }
  std::string key;
  for (const auto& [muscle, amount] : recipe) key += without_side(muscle);
  Dice own = dice_.about(key);
  if (own.chance(lacks_)) return false;
  const std::string first = without_side(recipe.front().first);
  const bool lid = first == "blink_" || first == "lid_in_" || first == "lid_out_";
  double strength = own.about_one(lid ? 0.04 : 0.15);
  if (own.chance(strength_)) strength = lid ? own.real(0.6, 1.05) : own.real(0.2, 1.6);
  if (weak_smiles_ && first == "smile_") strength = own.real(0.12, 0.35);
  if (weak_smiles_ && (first == "pucker" || first == "funnel")) strength = own.real(1, 1.5);
  Recipe made = recipe;
  for (const auto& [muscle, amount] : recipe) {
    const std::string base = is_paired(muscle) ? without_side(muscle) : muscle;
    for (const Spill& spill : k_spills) {
      if (base != spill.from) continue;
      Dice spilt = dice_.about(key + " from " + base + " onto " + spill.onto);
      const double share = spilt.chance(0.5) ? spill_ * spilt.real(0, spill.most) : 0;
      if (share == 0) continue;
      const std::string onto = spill.onto;
      if (onto.back() != '_') {
        made.emplace_back(onto, amount * share * (is_paired(muscle) ? 0.5 : 1));
      } else if (is_paired(muscle)) {
        made.emplace_back(onto + muscle.back(), amount * share);
      } else {
        made.emplace_back(onto + "L", amount * share);
        made.emplace_back(onto + "R", amount * share);
      }
    }
  }
  std::erase_if(made, [&](const auto& part) { return !parts_.fields.contains(part.first); });
  for (auto& [muscle, amount] : made) amount *= strength;
  recipe = std::move(made);
  return true;
}

}  // namespace penpose::judges
