#pragma once

#include <cstdint>

namespace penpose::app {

/// Keys that are no character.
inline constexpr std::uint32_t k_key_escape = 27;
inline constexpr std::uint32_t k_key_tab = 9;
inline constexpr std::uint32_t k_key_delete = 127;
inline constexpr std::uint32_t k_key_home = 0x110000;
inline constexpr std::uint32_t k_key_left = 0x110001;
inline constexpr std::uint32_t k_key_right = 0x110002;
inline constexpr std::uint32_t k_key_up = 0x110003;
inline constexpr std::uint32_t k_key_down = 0x110004;
inline constexpr std::uint32_t k_key_f1 = 0x110005;
inline constexpr std::uint32_t k_key_f11 = 0x110006;

struct KeyStroke {
  std::uint32_t key = 0;  ///< the character without shift, in lower case, or one of the constants; 0: none
  bool ctrl = false;
  bool shift = false;
  friend bool operator==(const KeyStroke&, const KeyStroke&) = default;
};

/// A key without Ctrl and Shift.
constexpr KeyStroke plain_key(std::uint32_t key) { return {key, false, false}; }

}  // namespace penpose::app
