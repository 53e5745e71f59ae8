#include "tests/judges/rigs/random/shapes.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "tests/judges/rigs/control_words.h"
#include "tests/judges/rigs/random/faces.h"
#include "tests/judges/rigs/sets.h"

namespace penpose::judges {
namespace {

struct Muscle {
  const char* name;  ///< of the paired without their side
  double common;     ///< the share of rich rigs that have it
};

constexpr std::array<Muscle, 33> k_muscles{{
    {"smile_", 1},           {"frown_", 0.95},        {"stretch_", 0.7},    {"dimple_", 0.4},     {"press_", 0.4},
    {"upper_up_", 0.75},     {"lower_down_", 0.7},    {"cheek_", 0.5},      {"puff_", 0.4},       {"sneer_", 0.6},
    {"brow_inner_up_", 0.9}, {"brow_outer_up_", 0.8}, {"brow_down_", 0.9},  {"blink_", 1},        {"wide_", 0.75},
    {"squint_", 0.6},        {"look_up_", 0.6},       {"look_down_", 0.6},  {"look_left_", 0.5},  {"look_right_", 0.5},
    {"pucker", 0.9},         {"funnel", 0.7},         {"jaw_open", 1},      {"jaw_L", 0.35},      {"jaw_R", 0.35},
    {"jaw_forward", 0.3},    {"mouth_L", 0.6},        {"mouth_R", 0.6},     {"roll_upper", 0.35}, {"roll_lower", 0.35},
    {"shrug_upper", 0.35},   {"shrug_lower", 0.4},    {"lips_close", 0.25},
}};

struct Half {
  const char* name;
  std::vector<const char*> means;
};

const std::vector<Half>& halves() {
  static const std::vector<Half> all{{"upper_in_up_", {"upper_up_"}},
                                     {"upper_out_up_", {"upper_up_"}},
                                     {"lower_in_down_", {"lower_down_"}},
                                     {"lower_out_down_", {"lower_down_"}},
                                     {"smile_top_", {"smile_"}},
                                     {"smile_bottom_", {"smile_"}},
                                     {"lid_in_", {}},
                                     {"lid_out_", {}},
                                     {"brow_mid_up_", {"brow_inner_up_", "brow_outer_up_"}}};
  return all;
}

/// Shapes that a maker has in mind, in no order yet.
class Planned {
 public:
  Planned(Names& names, const Dice& dice) : names_(names), dice_(dice), order_(dice.about("order")) {
    Dice own = dice.about("sides");
    const std::array<std::array<double, 4>, 4> k_habits{
        {{0.85, 0.1, 0.05, 0}, {0.05, 0.9, 0.05, 0}, {0.3, 0.3, 0.35, 0.05}, {0.1, 0.2, 0.65, 0.05}}};
    habit_ = own.one_of(k_habits);
  }

  void shape(const std::string& word, Recipe recipe, std::optional<Means> means = {}) {
    shapes_.push_back({names_.control(word), std::move(recipe), std::move(means), false});
  }
  void named(std::string name, Recipe recipe, std::optional<Means> means) {
    shapes_.push_back({std::move(name), std::move(recipe), std::move(means), false});
  }
  void emote(std::string name, Recipe recipe) { shapes_.push_back({std::move(name), std::move(recipe), {}, true}); }

  /// Muscles that make one shape a side, or one of both, as this maker does it.
  void paired(const std::string& word, const std::vector<std::pair<std::string, double>>& muscles) {
    double left = Dice(dice_.about("sides of " + word)).real(0, 1);
    std::size_t how = 0;
    while (how < 3 && left >= habit_[how]) left -= habit_[how++];
    const auto of = [&](bool left_side, bool right_side) {
      Recipe recipe;
      for (const auto& [muscle, amount] : muscles) {
        if (left_side) recipe.emplace_back(muscle + "L", amount);
        if (right_side) recipe.emplace_back(muscle + "R", amount);
      }
      return recipe;
    };
    if (how == 0 || how == 2) shape(word, of(true, true));
    if (how == 1 || how == 2) {
      shape(word + "L", of(true, false));
      shape(word + "R", of(false, true));
    }
    // Of one side only, and of both for the other.
    if (how == 3) {
      shape(word, of(true, true));
      const bool left_side = order_.chance(0.5);
      shape(word + (left_side ? "L" : "R"), of(left_side, !left_side));
    }
  }

  void add_to(FaceBuilder& face) {
    if (order_.chance(0.5)) {
      for (std::size_t i = shapes_.size(); i > 1; --i) std::swap(shapes_[i - 1], shapes_[order_.below(i)]);
    }
    for (Shape& one : shapes_) {
      if (one.emote) {
        face.emote(one.name, one.recipe);
      } else {
        face.shape(one.name, one.recipe, std::move(one.means));
      }
    }
  }

 private:
  struct Shape {
    std::string name;
    Recipe recipe;
    std::optional<Means> means;
    bool emote;
  };
  Names& names_;
  const Dice& dice_;
  Dice order_;
  std::array<double, 4> habit_{};  ///< shares of both in one, each side, both kinds, one side alone
  std::vector<Shape> shapes_;
};

void add_muscles(Planned& planned, const Dice& dice, double rich, const Means& without) {
  const bool whole_brows = Dice(dice.about("whole brows")).chance(0.4);
  const bool parts_of_brows = !whole_brows || Dice(dice.about("parts of brows")).chance(0.4);
  for (const Muscle& muscle : k_muscles) {
    const std::string name = muscle.name;
    const double share = std::min(1.0, muscle.common * (0.35 + 0.8 * rich));
    const bool gaze = name.starts_with("look_");
    if (!Dice(dice.about(gaze ? "gaze" : "has " + name)).chance(share)) continue;
    if (has(without, name)) continue;
    if (!parts_of_brows && (name == "brow_inner_up_" || name == "brow_outer_up_")) continue;
    if (name.back() == '_') {
      planned.paired(name, {{name, 1}});
    } else {
      planned.shape(name, {{name, 1}});
    }
  }
  if (whole_brows) planned.paired("brow_up_", {{"brow_inner_up_", 1}, {"brow_outer_up_", 1}});
}

/// Mouths that no single muscle makes, where a rig has no others that are narrow or open. Returns the muscles that are
/// left out for them.
Means add_mixed_mouths(Planned& planned, Dice own) {
  Means without;
  if (own.chance(0.75)) {
    if (own.chance(0.8)) planned.shape("ooh", {{"pucker", own.real(0.7, 1)}, {"jaw_open", own.real(0.1, 0.35)}});
    without = {"pucker", "funnel"};
  }
  if (without.empty() || own.chance(0.6)) {
    planned.shape("open_mouth", {{"jaw_open", own.real(0.75, 1)}, {"pucker", own.real(0.15, 0.45)}});
    without.emplace_back("jaw_open");
  }
  return without;
}

void add_halves_of(Planned& planned, const Dice& dice) {
  for (const Half& half : halves()) {
    if (!Dice(dice.about(half.name)).chance(0.6)) continue;
    for (const char* side : {"L", "R"}) {
      Means means;
      for (const char* muscle : half.means) means.push_back(std::string(muscle) + side);
      planned.shape(std::string(half.name) + side, {{std::string(half.name) + side, 1}}, std::move(means));
    }
  }
}

void add_sums(Planned& planned, Dice dice, std::size_t count) {
  const std::array<const char*, 16> from{
      "smile_",         "frown_",         "stretch_",   "upper_up_", "lower_down_", "sneer_", "cheek_", "jaw_open",
      "brow_inner_up_", "brow_outer_up_", "brow_down_", "squint_",   "blink_",      "pucker", "funnel", "jaw_open"};
  for (std::size_t k = 0; k < count; ++k) {
    const std::string a = dice.one_of(from);
    const std::string b = dice.one_of(from);
    if (a == b) continue;
    const double share = dice.real(0.55, 1);
    const std::size_t side = dice.below(3);
    Recipe recipe;
    for (const auto& [muscle, amount] : {std::pair{a, 0.7}, std::pair{b, 0.7 * share}}) {
      if (muscle.back() != '_') recipe.emplace_back(muscle, amount);
      if (muscle.back() == '_' && side != 1) recipe.emplace_back(muscle + "L", amount);
      if (muscle.back() == '_' && side != 0) recipe.emplace_back(muscle + "R", amount);
    }
    const auto word = [](const std::string& muscle) {
      return muscle.back() == '_' ? muscle.substr(0, muscle.size() - 1) : muscle;
    };
    planned.shape(word(a) + "_" + word(b) + (side == 0 ? "_L" : side == 1 ? "_R" : ""), std::move(recipe));
  }
}

struct Sound {
  const char* name;
  std::vector<std::tuple<const char*, double, double>> made_of;  ///< muscle, least, most
};

const std::vector<Sound>& sounds() {
  static const std::vector<Sound> all{
      {"aa", {{"jaw_open", 0.5, 0.9}, {"lower_down_", 0, 0.4}, {"upper_up_", 0, 0.3}, {"stretch_", -0.1, 0.3}}},
      {"E", {{"stretch_", 0.4, 0.8}, {"jaw_open", 0.1, 0.35}, {"upper_up_", 0, 0.4}, {"smile_", 0, 0.3}}},
      {"ih", {{"stretch_", 0.2, 0.6}, {"jaw_open", 0.05, 0.3}, {"smile_", 0, 0.4}}},
      {"oh", {{"funnel", 0.4, 0.9}, {"jaw_open", 0.2, 0.6}, {"lower_down_", 0, 0.3}}},
      {"ou", {{"pucker", 0.6, 1}, {"funnel", 0, 0.4}, {"jaw_open", 0, 0.25}}},
      {"PP", {{"press_", 0.5, 1}, {"roll_upper", 0, 0.6}, {"roll_lower", 0, 0.6}}},
      {"FF", {{"roll_lower", 0.5, 1}, {"upper_up_", 0.1, 0.5}}},
      {"TH", {{"jaw_open", 0.1, 0.3}, {"lower_down_", 0, 0.4}, {"upper_up_", 0, 0.3}}},
      {"DD", {{"jaw_open", 0.05, 0.25}, {"upper_up_", 0, 0.4}, {"stretch_", 0, 0.3}}},
      {"kk", {{"jaw_open", 0.1, 0.35}, {"stretch_", 0, 0.3}, {"upper_up_", 0, 0.4}}},
      {"CH", {{"funnel", 0.4, 0.9}, {"pucker", 0, 0.5}, {"jaw_open", 0, 0.15}}},
      {"SS", {{"stretch_", 0.1, 0.5}, {"lower_down_", 0, 0.4}, {"smile_", 0, 0.3}}},
      {"nn", {{"jaw_open", 0.05, 0.2}, {"upper_up_", 0, 0.3}, {"stretch_", 0, 0.2}}},
      {"RR", {{"funnel", 0.2, 0.6}, {"jaw_open", 0, 0.2}, {"pucker", 0, 0.3}}}};
  return all;
}

/// Mouths of speech. Each is for a sound, so nobody means it by a line, unless the rig has no other mouths.
void add_mouths_of_speech(Planned& planned, const std::string& before, Dice own, bool alone) {
  for (const Sound& sound : sounds()) {
    Recipe recipe;
    for (const auto& [muscle, least, most] : sound.made_of) {
      const double amount = own.real(least, most);
      const std::string name = muscle;
      if (name.back() == '_') {
        recipe.emplace_back(name + "L", amount);
        recipe.emplace_back(name + "R", amount);
      } else {
        recipe.emplace_back(name, amount);
      }
    }
    if (alone) {
      planned.named(before + sound.name, std::move(recipe), {});
    } else {
      planned.named(before + sound.name, std::move(recipe), Means{});
    }
  }
}

}  // namespace

std::size_t corrections_of(const Dice& dice) {
  Dice own = dice.about("corrections");
  return own.chance(0.75) ? 0 : own.count(2, 30);
}

std::string add_random_shapes(FaceBuilder& face, const Parts& parts, Names& names, const Dice& dice) {
  Dice own = dice.about("sets");
  Planned planned(names, dice);
  const double set = own.real(0, 1);
  const double size = own.real(0, 1);
  const double rich = size < 0.3 ? own.real(0, 0.25) : size < 0.75 ? own.real(0.25, 0.8) : own.real(0.8, 1);
  const bool many = size > 0.9;
  const bool arkit = set < 0.14 || set > 0.88;
  const bool vrm = set >= 0.14 && set < 0.3;
  const bool alone = vrm && own.chance(0.35);
  if (arkit) add_arkit(face);
  const bool mixed = !arkit && !alone && Dice(dice.about("mixed mouths")).chance(0.22);
  Means without;
  if (mixed) without = add_mixed_mouths(planned, dice.about("forms of mixed mouths"));
  if (!alone && (!arkit || own.chance(0.3))) add_muscles(planned, dice, arkit ? 0.2 * rich : rich, without);
  if (alone) {
    planned.paired("blink_", {{"blink_", 1}});
    planned.shape("jaw_open", {{"jaw_open", 0.8}});
  }
  const std::array<const char*, 5> k_before{"viseme_", "", "Fcl_MTH_", "V_", "mouth_"};
  const std::string before = own.one_of(k_before);
  const bool speaks = own.chance(arkit ? 0.5 : 0.2);
  if (vrm || (speaks && !mixed)) add_mouths_of_speech(planned, before, dice.about("speech"), vrm && alone);
  if (vrm || own.chance(0.35) || mixed) {
    for (const auto& [name, recipe] : random_faces(dice, vrm || mixed)) planned.emote(name, recipe);
  }
  if (many || own.chance(0.25)) add_halves_of(planned, dice.about("halves"));
  if (many || own.chance(0.3)) add_sums(planned, dice.about("sums"), many ? own.count(50, 150) : own.count(2, 12));
  for (std::size_t k = 0; k < corrections_of(dice); ++k)
    planned.shape("corrective" + std::to_string(k), {{"fix_" + std::to_string(k), 1}}, Means{});
  if (own.chance(0.4)) {
    for (const char* useless : {"nothing", "all", "hair", "ears", "teeth", "tongue"}) {
      if (parts.fields.contains(useless) && own.chance(0.5)) planned.shape(useless, {{useless, 1}}, Means{});
    }
  }
  planned.add_to(face);
  return arkit ? "ARKit's names" : alone ? "whole faces" : vrm ? "whole faces and single shapes" : "shapes of its own";
}

}  // namespace penpose::judges
