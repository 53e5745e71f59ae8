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

constexpr std::array<Spill, 34> k_spills{{
    {"smile_", "cheek_", 0.5},         {"smile_", "squint_", 0.3},       {"smile_", "dimple_", 0.3},
    {"smile_", "stretch_", 0.3},       {"smile_", "upper_up_", 0.25},    {"frown_", "shrug_lower", 0.4},
    {"frown_", "lower_down_", 0.25},   {"frown_", "stretch_", 0.2},      {"brow_inner_up_", "brow_outer_up_", 0.3},
    {"brow_inner_up_", "wide_", 0.15}, {"brow_outer_up_", "wide_", 0.2}, {"brow_outer_up_", "brow_inner_up_", 0.3},
    {"brow_down_", "squint_", 0.25},   {"brow_down_", "sneer_", 0.3},    {"brow_down_", "blink_", 0.12},
    {"pucker", "shrug_lower", 0.35},   {"pucker", "funnel", 0.3},        {"pucker", "jaw_open", 0.08},
    {"funnel", "pucker", 0.3},         {"funnel", "jaw_open", 0.12},     {"blink_", "squint_", 0.4},
    {"blink_", "cheek_", 0.15},        {"blink_", "brow_down_", 0.1},    {"wide_", "brow_outer_up_", 0.2},
    {"jaw_open", "lower_down_", 0.25}, {"jaw_open", "frown_", 0.12},     {"jaw_open", "pucker", 0.2},
    {"upper_up_", "sneer_", 0.35},     {"sneer_", "upper_up_", 0.35},    {"sneer_", "brow_down_", 0.2},
    {"stretch_", "press_", 0.3},       {"mouth_L", "jaw_L", 0.35},       {"mouth_R", "jaw_R", 0.35},
    {"lower_down_", "stretch_", 0.2},
}};

}  // namespace

Taste::Taste(const Parts& parts, const Dice& dice) : parts_(parts), dice_(dice) {
  Dice own = dice.about("taste");
  spill_ = own.chance(0.25) ? 0 : own.real(0.3, 1);
  strength_ = own.chance(0.3) ? 0 : own.real(0.1, 0.8);
  lacks_ = own.chance(0.5) ? 0 : own.real(0, 0.25);
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
  Recipe made = recipe;
  for (const auto& [muscle, amount] : recipe) {
    const std::string base = is_paired(muscle) ? without_side(muscle) : muscle;
    for (const Spill& spill : k_spills) {
      if (base != spill.from) continue;
      const double share = own.chance(0.5) ? spill_ * own.real(0, spill.most) : 0;
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
