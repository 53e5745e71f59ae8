#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace penpose::app {

/// Keys that are no character that is seen.
inline constexpr std::uint32_t k_key_backspace = 8;
inline constexpr std::uint32_t k_key_tab = 9;
inline constexpr std::uint32_t k_key_return = 13;
inline constexpr std::uint32_t k_key_escape = 27;
inline constexpr std::uint32_t k_key_delete = 127;
inline constexpr std::uint32_t k_key_home = 0x110000;
inline constexpr std::uint32_t k_key_left = 0x110001;
inline constexpr std::uint32_t k_key_right = 0x110002;
inline constexpr std::uint32_t k_key_up = 0x110003;
inline constexpr std::uint32_t k_key_down = 0x110004;
inline constexpr std::uint32_t k_key_end = 0x110005;
inline constexpr std::uint32_t k_key_page_up = 0x110006;
inline constexpr std::uint32_t k_key_page_down = 0x110007;
inline constexpr std::uint32_t k_key_insert = 0x110008;
/// F1, the others behind it.
inline constexpr std::uint32_t k_key_f1 = 0x110100;
inline constexpr std::uint32_t k_key_f11 = k_key_f1 + 10;
inline constexpr std::uint32_t k_function_keys = 24;

/// 0 of the keypad, the other digits behind it.
inline constexpr std::uint32_t k_key_pad_0 = 0x110200;
[[nodiscard]] constexpr std::uint32_t pad_key(std::uint32_t digit) { return k_key_pad_0 + digit; }

struct KeyStroke {
  std::uint32_t key = 0;  ///< the character without shift, in lower case, or one of the constants; 0: none
  bool ctrl = false;
  bool shift = false;
  friend bool operator==(const KeyStroke&, const KeyStroke&) = default;
};

/// A key without Ctrl and Shift.
constexpr KeyStroke plain_key(std::uint32_t key) { return {key, false, false}; }

/// As actions name it: where + lies on the key of =, as on most keyboards, it is typed with Shift.
constexpr KeyStroke as_actions_name(const KeyStroke& pressed) {
  return pressed.key == '=' && pressed.shift ? KeyStroke{'+', pressed.ctrl, false} : pressed;
}
/// Esc and Return, which dialogs need: no action gets them.
constexpr bool is_reserved(const KeyStroke& key) { return key.key == k_key_escape || key.key == k_key_return; }

/// "Ctrl+Shift+Z"; empty where there is none.
[[nodiscard]] std::string shortcut_text(const KeyStroke& key);
/// The stroke of such a text; nothing where it is none.
[[nodiscard]] std::optional<KeyStroke> parse_shortcut(std::string_view text);

}  // namespace penpose::app
