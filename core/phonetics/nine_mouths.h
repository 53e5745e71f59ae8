#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace penpose::speech {

/// The nine mouths that speech is drawn with: the shapes A to H and X of Rhubarb Lip Sync, whose documentation
/// describes them and names the tables that they come from (the six of Hanna-Barbera, with those of Preston Blair for
/// F, L and the mouth at rest).
enum class NineMouth : std::uint8_t {
  closed,      ///< A: m, b, p
  consonants,  ///< B: k, s, t; teeth nearly closed
  e,           ///< C: as in men
  a,           ///< D: as in father
  o,           ///< E: slightly rounded
  u,           ///< F: puckered, w
  f,           ///< G: f, v; upper teeth on the lower lip
  l,           ///< H: the tongue up behind the teeth
  rest,        ///< X
};
inline constexpr std::size_t k_nine = 9;

/// The names of the mouths: "closed", "consonants", "E", "A", "O", "U", "F", "L", "rest".
extern const std::array<std::string_view, k_nine> k_mouth_names;
/// Rhubarb's letters of them.
inline constexpr std::string_view k_mouth_letters = "ABCDEFGHX";

[[nodiscard]] std::string_view name_of(NineMouth mouth);

/// The mouth of one of Preston Blair's ("AI", "E", "O", "U", "etc", "L", "WQ", "MBP", "FV", "rest", in any case), as
/// Papagayo writes them; their share of the nine is that of Rhubarb's documentation. Any other name stays one.
[[nodiscard]] std::string mouth_of_blair(std::string_view name);

/// The mouth of a phoneme of the CMU dictionary, with or without a digit of stress: Papagayo's table of Preston Blair's
/// mouths, but that HH, G, K, N and NG, which lips do not make, are consonants. What is none is rest.
[[nodiscard]] NineMouth mouth_of_phoneme(std::string_view phoneme);

/// Whether lips or teeth have to meet for a mouth to be read: closed, F.
[[nodiscard]] constexpr bool must_meet(NineMouth mouth) { return mouth == NineMouth::closed || mouth == NineMouth::f; }

}  // namespace penpose::speech
