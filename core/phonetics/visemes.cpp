#include "core/phonetics/visemes.h"

#include <array>
#include <utility>

#include "core/base/text/letters.h"

namespace penpose::speech {
namespace {

constexpr std::pair<std::string_view, NineMouth> k_polly[]{
    {"sil", NineMouth::rest},     {"p", NineMouth::closed},     {"B", NineMouth::closed},
    {"t", NineMouth::consonants}, {"S", NineMouth::consonants}, {"T", NineMouth::consonants},
    {"k", NineMouth::consonants}, {"r", NineMouth::consonants}, {"s", NineMouth::consonants},
    {"J", NineMouth::consonants}, {"x", NineMouth::consonants}, {"f", NineMouth::f},
    {"l", NineMouth::l},          {"i", NineMouth::e},          {"e", NineMouth::e},
    {"E", NineMouth::e},          {"@", NineMouth::a},          {"a", NineMouth::a},
    {"o", NineMouth::o},          {"O", NineMouth::o},          {"u", NineMouth::u},
};

/// By the number of the viseme, from 0.
constexpr std::array k_azure{
    NineMouth::rest,        // silence
    NineMouth::a,           // ae, ax, ah
    NineMouth::a,           // aa
    NineMouth::o,           // ao
    NineMouth::e,           // ey, eh, uh
    NineMouth::e,           // er
    NineMouth::e,           // y, iy, ih, ix
    NineMouth::u,           // w, uw
    NineMouth::o,           // ow
    NineMouth::o,           // aw
    NineMouth::o,           // oy
    NineMouth::a,           // ay
    NineMouth::consonants,  // h
    NineMouth::consonants,  // r
    NineMouth::l,           // l
    NineMouth::consonants,  // s, z
    NineMouth::consonants,  // sh, ch, jh, zh
    NineMouth::consonants,  // th, dh
    NineMouth::f,           // f, v
    NineMouth::consonants,  // d, t, n
    NineMouth::consonants,  // k, g, ng
    NineMouth::closed,      // p, b, m
};

constexpr std::pair<std::string_view, NineMouth> k_oculus[]{
    {"sil", NineMouth::rest},      {"PP", NineMouth::closed},     {"FF", NineMouth::f},
    {"TH", NineMouth::consonants}, {"DD", NineMouth::consonants}, {"kk", NineMouth::consonants},
    {"CH", NineMouth::consonants}, {"SS", NineMouth::consonants}, {"nn", NineMouth::l},
    {"RR", NineMouth::consonants}, {"aa", NineMouth::a},          {"ih", NineMouth::e},
    {"oh", NineMouth::o},          {"ou", NineMouth::u},
};

constexpr std::pair<std::string_view, NineMouth> k_oculus_letters[]{
    {"E", NineMouth::e}, {"I", NineMouth::e}, {"O", NineMouth::o}, {"U", NineMouth::u}};

}  // namespace

std::optional<NineMouth> mouth_of_polly(std::string_view viseme) {
  for (const auto& [name, mouth] : k_polly) {
    if (name == viseme) return mouth;
  }
  return std::nullopt;
}

std::optional<NineMouth> mouth_of_azure(std::int64_t viseme) {
  if (viseme < 0 || viseme >= static_cast<std::int64_t>(k_azure.size())) return std::nullopt;
  return k_azure[static_cast<std::size_t>(viseme)];
}

std::optional<NineMouth> mouth_of_oculus(std::string_view viseme) {
  constexpr std::string_view k_prefix = "viseme_";
  const bool full = viseme.size() > k_prefix.size() && base::same_but_case(viseme.substr(0, k_prefix.size()), k_prefix);
  const std::string_view name = full ? viseme.substr(k_prefix.size()) : viseme;
  for (const auto& [one, mouth] : k_oculus) {
    if (base::same_but_case(one, name)) return mouth;
  }
  for (const auto& [one, mouth] : k_oculus_letters) {
    if (full && base::same_but_case(one, name)) return mouth;
  }
  return std::nullopt;
}

}  // namespace penpose::speech
