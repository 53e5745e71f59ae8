#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/document/words/face_deeds.h"
#include "core/document/words/readable_name.h"
#include "core/rig/control_names.h"

namespace penpose::document {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

/// Folded names without their side, as ARKit, the Facial Action Coding System and VRM give them, and the deed they
/// mean.
constexpr std::array k_named_deeds{
    Pair{"browdown", "brow down"},
    Pair{"browlowerer", "brow down"},
    Pair{"browinnerup", "inner brow raised"},
    Pair{"innerbrowraiser", "inner brow raised"},
    Pair{"browouterup", "outer brow raised"},
    Pair{"outerbrowraiser", "outer brow raised"},
    Pair{"cheekpuff", "cheek puffs"},
    Pair{"cheeksuck", "cheek sucked in"},
    Pair{"cheeksquint", "cheek raised"},
    Pair{"cheekraiser", "cheek raised"},
    Pair{"eyeblink", "eye closes"},
    Pair{"blink", "eye closes"},
    Pair{"eyeclose", "eye closes"},
    Pair{"eyesclosed", "eye closes"},
    Pair{"eyelookdown", "eye looks down"},
    Pair{"eyeslookdown", "eye looks down"},
    Pair{"eyelookup", "eye looks up"},
    Pair{"eyeslookup", "eye looks up"},
    Pair{"eyelookin", "eye looks in"},
    Pair{"eyelookout", "eye looks out"},
    Pair{"eyesquint", "lower lid raised"},
    Pair{"lidtightener", "lower lid raised"},
    Pair{"eyewide", "eye wide"},
    Pair{"upperlidraiser", "eye wide"},
    Pair{"jawforward", "jaw forward"},
    Pair{"jawthrust", "jaw forward"},
    Pair{"jawopen", "jaw opens"},
    Pair{"jawdrop", "jaw opens"},
    Pair{"mouthopen", "mouth opens"},
    Pair{"mouthclose", "lips close"},
    Pair{"mouthdimple", "dimple"},
    Pair{"dimpler", "dimple"},
    Pair{"mouthfrown", "mouth corner down"},
    Pair{"lipcornerdepressor", "mouth corner down"},
    Pair{"mouthfunnel", "lips funnel"},
    Pair{"mouthlowerdown", "lower lip down"},
    Pair{"lowerlipdepressor", "lower lip down"},
    Pair{"mouthpress", "lips press"},
    Pair{"lippressor", "lips press"},
    Pair{"mouthpucker", "lips pucker"},
    Pair{"lippucker", "lips pucker"},
    Pair{"mouthrolllower", "lower lip rolls in"},
    Pair{"bottomlipsuck", "lower lip rolls in"},
    Pair{"mouthrollupper", "upper lip rolls in"},
    Pair{"toplipsuck", "upper lip rolls in"},
    Pair{"bottomlipfunneler", "lower lip forward"},
    Pair{"toplipfunneler", "upper lip forward"},
    Pair{"mouthshruglower", "lower lip raised"},
    Pair{"chinraiser", "chin raised"},
    Pair{"mouthshrugupper", "upper lip raised"},
    Pair{"mouthsmile", "smile"},
    Pair{"lipcornerpuller", "smile"},
    Pair{"mouthstretch", "mouth stretches"},
    Pair{"lipstretcher", "mouth stretches"},
    Pair{"mouthupperup", "upper lip raised"},
    Pair{"upperlipraiser", "upper lip raised"},
    Pair{"nosesneer", "nose wrinkles"},
    Pair{"nosewrinkler", "nose wrinkles"},
    Pair{"nostrildilator", "nostril widens"},
    Pair{"tongueout", "tongue out"},
};

/// Sounds, as folded names end; the longer ones first.
constexpr std::array<std::string_view, 21> k_sounds{"sil", "pp", "ff", "th", "dd", "kk", "ch", "ss", "nn", "rr", "aa",
                                                    "ee",  "ih", "oh", "ou", "a",  "e",  "i",  "o",  "u",  "n"};
/// What stands before a sound.
constexpr std::array<std::string_view, 5> k_before_sounds{"viseme", "vrcv", "mth", "mouth", "vis"};

constexpr std::array k_feelings{
    Pair{"joy", "joy"},    Pair{"angry", "anger"},    Pair{"anger", "anger"},        Pair{"sorrow", "sorrow"},
    Pair{"sad", "sorrow"}, Pair{"fun", "fun"},        Pair{"surprised", "surprise"}, Pair{"relaxed", "relaxed"},
    Pair{"happy", "joy"},  Pair{"neutral", "neutral"}};

/// A name without its side as it is folded, and without its first words, the longest first.
std::vector<std::string> forms_of(std::string_view control) {
  const std::string words = readable_name(control).what;
  std::vector<std::string> forms;
  for (std::size_t at = 0; at != std::string::npos; at = words.find(' ', at + 1))
    forms.push_back(rig::folded_name(words.substr(at)));
  return forms;
}

}  // namespace

std::optional<Deed> deed_named(std::string_view control) {
  for (const std::string& form : forms_of(control)) {
    for (const auto& [name, meant] : k_named_deeds) {
      if (form == name) return deed_of_words(meant);
    }
  }
  return std::nullopt;
}

std::string expression_named(std::string_view control) {
  const std::string name = rig::folded_name(control);
  for (const std::string_view before : k_before_sounds) {
    const std::size_t at = name.rfind(before);
    if (at == std::string::npos) continue;
    const std::string rest = name.substr(at + before.size());
    if (std::find(k_sounds.begin(), k_sounds.end(), rest) == k_sounds.end()) continue;
    return rest == "sil" ? "mouth: silence" : "mouth: " + rest;
  }
  if (name.size() <= 2 && std::find(k_sounds.begin(), k_sounds.end(), name) != k_sounds.end()) return "mouth: " + name;
  for (const auto& [feeling, words] : k_feelings) {
    if (name == feeling) return std::string(words);
  }
  return {};
}

}  // namespace penpose::document
