#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/document/words/face_deeds.h"
#include "core/document/words/readable_name.h"
#include "core/rig/control_names.h"
#include "core/rig/names/face_names.h"

namespace penpose::document {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

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
    const auto name = rig::face_name(form);
    if (!name) continue;
    const std::string& words = rig::face_meanings()[name->meaning].words;
    if (!words.empty()) return deed_of_words(words);
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
