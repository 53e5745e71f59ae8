#include "ui/app/key_stroke.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/base/text/utf8.h"

namespace penpose::app {
namespace {

/// The bar separates keys where they are kept.
constexpr std::array<std::pair<std::uint32_t, std::string_view>, 16> k_names{{{k_key_escape, "Esc"},
                                                                              {k_key_tab, "Tab"},
                                                                              {k_key_delete, "Del"},
                                                                              {k_key_backspace, "Backspace"},
                                                                              {k_key_return, "Return"},
                                                                              {k_key_home, "Home"},
                                                                              {k_key_end, "End"},
                                                                              {k_key_page_up, "PageUp"},
                                                                              {k_key_page_down, "PageDown"},
                                                                              {k_key_insert, "Insert"},
                                                                              {k_key_left, "Left"},
                                                                              {k_key_right, "Right"},
                                                                              {k_key_up, "Up"},
                                                                              {k_key_down, "Down"},
                                                                              {' ', "Space"},
                                                                              {'|', "Bar"}}};

/// Before a digit of the keypad.
constexpr std::string_view k_pad = "Num";

std::string key_name(std::uint32_t key) {
  for (const auto& [named, name] : k_names) {
    if (named == key) return std::string(name);
  }
  if (key >= k_key_f1 && key < k_key_f1 + k_function_keys) return "F" + std::to_string(key - k_key_f1 + 1);
  if (key >= pad_key(0) && key <= pad_key(9)) return std::string(k_pad).append(std::to_string(key - k_key_pad_0));
  if (key < 128) return {base::upper(static_cast<char>(key))};
  return base::utf8_of(static_cast<char32_t>(key));
}

/// The one character of a text; 0 where it is none or more.
std::uint32_t character_of(std::string_view text) {
  if (text.empty() || base::utf8_sequence_length(text) != text.size()) return 0;
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  if (text.size() == 1) {
    const bool seen = byte(0) > ' ' && byte(0) < 127;
    return seen ? static_cast<std::uint32_t>(base::lower(text[0])) : 0;
  }
  std::uint32_t code = byte(0) & (0x7FU >> text.size());
  for (std::size_t i = 1; i < text.size(); ++i) code = code << 6U | (byte(i) & 0x3FU);
  return code >= 0xA0 ? code : 0;
}

std::uint32_t key_named(std::string_view name) {
  for (const auto& [key, named] : k_names) {
    if (named == name) return key;
  }
  if (name.size() > 1 && name.front() == 'F') {
    const auto number = base::parse_int(name.substr(1));
    if (number && *number >= 1 && *number <= static_cast<std::int64_t>(k_function_keys))
      return k_key_f1 + static_cast<std::uint32_t>(*number) - 1;
  }
  if (name.starts_with(k_pad)) {
    const auto digit = base::parse_int(name.substr(k_pad.size()));
    if (digit && *digit >= 0 && *digit <= 9) return pad_key(static_cast<std::uint32_t>(*digit));
  }
  return character_of(name);
}

}  // namespace

std::string shortcut_text(const KeyStroke& key) {
  if (key.key == 0) return {};
  return std::string(key.ctrl ? "Ctrl+" : "") + (key.shift ? "Shift+" : "") + key_name(key.key);
}

std::optional<KeyStroke> parse_shortcut(std::string_view text) {
  KeyStroke stroke;
  const auto takes = [&text](std::string_view held) {
    const bool is = text.size() > held.size() && text.starts_with(held);
    if (is) text.remove_prefix(held.size());
    return is;
  };
  stroke.ctrl = takes("Ctrl+");
  stroke.shift = takes("Shift+");
  stroke.key = key_named(text);
  if (stroke.key == 0) return std::nullopt;
  return stroke;
}

}  // namespace penpose::app
