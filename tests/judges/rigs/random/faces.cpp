#include "tests/judges/rigs/random/faces.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tests/judges/rigs/control_words.h"

namespace penpose::judges {
namespace {

struct Ingredient {
  const char* muscle;
  double share;  ///< of makers that use it
  double low, high;
};
struct Face {
  const char* name;
  std::vector<Ingredient> made_of;
};

const std::vector<Face>& known() {
  static const std::vector<Face> all{
      {"joy",
       {{"smile_", 1, 0.6, 1},
        {"jaw_open", 0.6, 0.1, 0.5},
        {"squint_", 0.6, 0.2, 0.8},
        {"cheek_", 0.5, 0.2, 0.8},
        {"blink_", 0.55, 0.3, 1},
        {"brow_outer_up_", 0.4, 0.2, 0.6},
        {"brow_inner_up_", 0.3, 0.2, 0.6}}},
      {"angry",
       {{"brow_down_", 1, 0.6, 1},
        {"frown_", 0.85, 0.2, 0.9},
        {"sneer_", 0.5, 0.2, 0.7},
        {"squint_", 0.4, 0.2, 0.6},
        {"stretch_", 0.3, 0.2, 0.5},
        {"jaw_open", 0.2, 0.1, 0.4}}},
      {"sorrow",
       {{"brow_inner_up_", 1, 0.5, 1},
        {"frown_", 0.8, 0.3, 1},
        {"blink_", 0.5, 0.1, 0.5},
        {"shrug_lower", 0.4, 0.2, 0.7}}},
      {"fun",
       {{"smile_", 1, 0.5, 1},
        {"squint_", 0.5, 0.2, 0.6},
        {"brow_outer_up_", 0.5, 0.2, 0.8},
        {"jaw_open", 0.5, 0.1, 0.5},
        {"stretch_", 0.3, 0.1, 0.4}}},
      {"surprised",
       {{"brow_inner_up_", 1, 0.5, 1},
        {"brow_outer_up_", 0.9, 0.5, 1},
        {"wide_", 0.9, 0.4, 1},
        {"jaw_open", 0.85, 0.2, 0.8},
        {"funnel", 0.4, 0.1, 0.5}}},
      {"disgust",
       {{"sneer_", 1, 0.5, 1},
        {"upper_up_", 0.8, 0.3, 0.8},
        {"brow_down_", 0.6, 0.2, 0.6},
        {"squint_", 0.5, 0.2, 0.6}}},
      {"fear",
       {{"wide_", 1, 0.5, 1},
        {"brow_inner_up_", 0.9, 0.5, 1},
        {"stretch_", 0.7, 0.3, 0.8},
        {"jaw_open", 0.5, 0.1, 0.4}}},
      {"sleepy", {{"blink_", 1, 0.4, 0.8}, {"brow_outer_up_", 0.4, 0.1, 0.4}, {"jaw_open", 0.4, 0.1, 0.3}}},
      {"kiss", {{"pucker", 1, 0.7, 1}, {"blink_", 0.85, 0.7, 1}, {"brow_inner_up_", 0.3, 0.2, 0.5}}},
      {"shout",
       {{"jaw_open", 1, 0.7, 1},
        {"brow_down_", 0.7, 0.4, 1},
        {"upper_up_", 0.6, 0.3, 0.7},
        {"squint_", 0.5, 0.2, 0.6}}},
      {"smug", {{"smile_L", 1, 0.5, 0.9}, {"brow_outer_up_R", 0.7, 0.4, 0.9}, {"blink_", 0.4, 0.2, 0.4}}},
      {"wink_smile", {{"blink_L", 1, 0.8, 1}, {"smile_L", 0.9, 0.4, 0.9}, {"cheek_L", 0.6, 0.3, 0.8}}},
  };
  return all;
}

/// Whether one undoes what the other does.
bool against(const Means& a, const Means& b) {
  constexpr std::array<std::pair<const char*, const char*>, 9> k_pairs{{{"smile_", "frown_"},
                                                                        {"pucker", "stretch_"},
                                                                        {"funnel", "stretch_"},
                                                                        {"mouth_L", "mouth_R"},
                                                                        {"jaw_L", "jaw_R"},
                                                                        {"blink_", "wide_"},
                                                                        {"brow_inner_up_", "brow_down_"},
                                                                        {"brow_outer_up_", "brow_down_"},
                                                                        {"pucker", "smile_"}}};
  const auto holds = [](const Means& means, std::string_view word) {
    return std::any_of(means.begin(), means.end(), [&](const std::string& m) { return m.starts_with(word); });
  };
  return std::any_of(a.begin(), a.end(), [&](const std::string& m) { return has(b, m); }) ||
         std::any_of(k_pairs.begin(), k_pairs.end(), [&](const auto& pair) {
           return (holds(a, pair.first) && holds(b, pair.second)) || (holds(b, pair.first) && holds(a, pair.second));
         });
}

}  // namespace

std::vector<std::pair<std::string, Recipe>> random_faces(const Dice& dice, bool standard) {
  Dice own = dice.about("faces");
  const std::array<const char*, 4> k_before{"", "Fcl_ALL_", "emo_", "Expression."};
  const std::string before = own.one_of(k_before);
  const double common = own.real(0.2, 0.9);
  std::vector<std::pair<std::string, Recipe>> faces;
  for (std::size_t k = 0; k < known().size(); ++k) {
    const Face& face = known()[k];
    if (!(standard && k < 5) && !own.chance(common)) continue;
    Recipe recipe;
    for (const Ingredient& part : face.made_of) {
      const bool used = own.chance(part.share);
      const double amount = own.real(part.low, part.high);
      const std::string muscle = part.muscle;
      if (!used) continue;
      if (muscle.back() == '_') {
        recipe.emplace_back(muscle + "L", amount);
        recipe.emplace_back(muscle + "R", amount);
      } else {
        recipe.emplace_back(muscle, amount);
      }
    }
    faces.emplace_back(before + face.name, std::move(recipe));
  }
  return faces;
}

std::vector<Expression> more_expressions() {
  return {{"half_lids", {{"blink_L", 0.5}, {"blink_R", 0.5}}},
          {"half_lid_R", {{"blink_R", 0.5}}},
          {"lower_teeth", {{"jaw_open", 0.35}, {"lower_down_L", 0.7}, {"lower_down_R", 0.7}}},
          {"kiss", {{"pucker", 0.8}, {"blink_L", 0.85}, {"blink_R", 0.85}}},
          {"joy", {{"smile_L", 0.7}, {"smile_R", 0.7}, {"blink_L", 0.6}, {"blink_R", 0.6}}},
          {"scowl", {{"brow_down_L", 0.9}, {"brow_down_R", 0.9}, {"frown_L", 0.6}, {"frown_R", 0.6}}},
          {"startled",
           {{"wide_L", 0.8},
            {"wide_R", 0.8},
            {"brow_inner_up_L", 0.6},
            {"brow_inner_up_R", 0.6},
            {"brow_outer_up_L", 0.6},
            {"brow_outer_up_R", 0.6}}}};
}

void add_random_poses(FaceBuilder& face, Dice dice, std::size_t count) {
  const auto acts = face.acts();
  if (acts.empty()) return;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t controls = dice.count(1, 4);
    std::vector<const FaceBuilder::Act*> chosen;
    for (std::size_t tries = 0; tries < 40 && chosen.size() < controls; ++tries) {
      const FaceBuilder::Act& act = dice.one_of(acts);
      // Whole faces and what is of no use are not often part of a pose.
      if (act.means.empty() && !dice.chance(0.1)) continue;
      const bool apart = std::none_of(chosen.begin(), chosen.end(), [&](const FaceBuilder::Act* other) {
        const bool shared = std::any_of(act.at_most.begin(), act.at_most.end(), [&](const auto& value) {
          return std::any_of(other->at_most.begin(), other->at_most.end(),
                             [&](const auto& theirs) { return control_of(theirs.first) == control_of(value.first); });
        });
        return shared || against(act.means, other->means);
      });
      if (!apart) continue;
      chosen.push_back(&act);
    }
    Values values;
    for (const FaceBuilder::Act* act : chosen) {
      const double amount = dice.real(0.25, 1);
      for (const auto& [parameter, at_most] : act->at_most)
        values.emplace_back(parameter, is_angle(parameter) ? amount * at_most : std::min(1.0, amount * at_most));
    }
    if (!values.empty()) face.pose("random_" + std::to_string(k), std::move(values));
  }
}

}  // namespace penpose::judges
