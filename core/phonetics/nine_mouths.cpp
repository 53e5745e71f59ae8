#include "core/phonetics/nine_mouths.h"

#include <utility>

#include "core/base/text/letters.h"

namespace penpose::speech {
namespace {

using enum NineMouth;

constexpr std::pair<std::string_view, NineMouth> k_blair[]{
    {"MBP", closed}, {"etc", consonants}, {"E", e},  {"AI", a}, {"O", o},
    {"U", u},        {"WQ", u},           {"FV", f}, {"L", l},  {"rest", rest},
};

constexpr std::pair<std::string_view, NineMouth> k_phonemes[]{
    {"AA", a},          {"AE", a},          {"AH", a},          {"AO", o},          {"AW", o},
    {"AY", a},          {"B", closed},      {"CH", consonants}, {"D", consonants},  {"DH", consonants},
    {"EH", e},          {"ER", e},          {"EY", e},          {"F", f},           {"G", consonants},
    {"HH", consonants}, {"IH", e},          {"IY", e},          {"JH", consonants}, {"K", consonants},
    {"L", l},           {"M", closed},      {"N", consonants},  {"NG", consonants}, {"OW", o},
    {"OY", u},          {"P", closed},      {"R", consonants},  {"S", consonants},  {"SH", consonants},
    {"T", consonants},  {"TH", consonants}, {"UH", u},          {"UW", u},          {"V", f},
    {"W", u},           {"Y", consonants},  {"Z", consonants},  {"ZH", consonants},
};

}  // namespace

const std::array<std::string_view, k_nine> k_mouth_names{"closed", "consonants", "E", "A", "O", "U", "F", "L", "rest"};

std::string_view name_of(NineMouth mouth) { return k_mouth_names[static_cast<std::size_t>(mouth)]; }

std::string mouth_of_blair(std::string_view name) {
  for (const auto& [blair, mouth] : k_blair) {
    if (base::same_but_case(blair, name)) return std::string(name_of(mouth));
  }
  return std::string(name);
}

NineMouth mouth_of_phoneme(std::string_view phoneme) {
  while (!phoneme.empty() && phoneme.back() >= '0' && phoneme.back() <= '9') phoneme.remove_suffix(1);
  for (const auto& [name, mouth] : k_phonemes) {
    if (base::same_but_case(name, phoneme)) return mouth;
  }
  return rest;
}

}  // namespace penpose::speech
