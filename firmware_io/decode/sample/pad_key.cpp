#include "firmware_io/decode/sample/pad_key.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

namespace penpose::decode {
namespace {

// Source of codes and names: Linux, include/uapi/linux/input-event-codes.h.

/// A stretch of keys whose codes follow each other.
struct Stretch {
  PadKey first;
  std::uint16_t code;
  std::uint16_t count;
};
constexpr auto k_stretches = std::to_array<Stretch>({
    {PadKey::program1, 148, 2},
    {PadKey::program3, 202, 1},
    {PadKey::button0, 0x100, k_button_codes},
    {PadKey::info, 0x166, 1},
    {PadKey::button_config, 0x240, 1},
    {PadKey::control_panel, 0x243, 1},
    {PadKey::screen_keyboard, 0x278, 1},
    {PadKey::extra1, 0x2c0, k_extra_keys},
});

struct Named {
  PadKey key;
  std::string_view name;
};
constexpr auto k_named = std::to_array<Named>({
    {PadKey::program1, "KEY_PROG1"},
    {PadKey::program2, "KEY_PROG2"},
    {PadKey::program3, "KEY_PROG3"},
    {PadKey::left, "BTN_LEFT"},
    {PadKey::right, "BTN_RIGHT"},
    {PadKey::middle, "BTN_MIDDLE"},
    {PadKey::side, "BTN_SIDE"},
    {PadKey::mouse_extra, "BTN_EXTRA"},
    {PadKey::forward, "BTN_FORWARD"},
    {PadKey::back, "BTN_BACK"},
    {PadKey::base, "BTN_BASE"},
    {PadKey::base2, "BTN_BASE2"},
    {PadKey::base3, "BTN_BASE3"},
    {PadKey::base4, "BTN_BASE4"},
    {PadKey::base5, "BTN_BASE5"},
    {PadKey::base6, "BTN_BASE6"},
    {PadKey::a, "BTN_A"},
    {PadKey::b, "BTN_B"},
    {PadKey::c, "BTN_C"},
    {PadKey::x, "BTN_X"},
    {PadKey::y, "BTN_Y"},
    {PadKey::z, "BTN_Z"},
    {PadKey::stylus, "BTN_STYLUS"},
    {PadKey::stylus2, "BTN_STYLUS2"},
    {PadKey::button_config, "KEY_BUTTONCONFIG"},
    {PadKey::control_panel, "KEY_CONTROLPANEL"},
    {PadKey::screen_keyboard, "KEY_ONSCREEN_KEYBOARD"},
});

}  // namespace

PadKeys numbered_keys(std::uint64_t pressed, unsigned count) {
  PadKeys keys;
  for (unsigned i = 0; i < std::min(count, k_numbered_keys); ++i) {
    if ((pressed >> i & 1) != 0) keys.set(numbered_key(i));
  }
  return keys;
}

std::uint16_t key_code(PadKey key) {
  const Stretch* of = k_stretches.data();
  for (const Stretch& stretch : k_stretches) {
    if (stretch.first <= key) of = &stretch;
  }
  return static_cast<std::uint16_t>(of->code + (static_cast<unsigned>(key) - static_cast<unsigned>(of->first)));
}

std::optional<PadKey> key_with_code(std::uint32_t code) {
  for (const Stretch& stretch : k_stretches) {
    if (code >= stretch.code && code < std::uint32_t{stretch.code} + stretch.count)
      return static_cast<PadKey>(static_cast<unsigned>(stretch.first) + (code - stretch.code));
  }
  return std::nullopt;
}

std::string key_name(PadKey key) {
  const auto number_from = [key](PadKey first) { return static_cast<unsigned>(key) - static_cast<unsigned>(first); };
  if (key >= PadKey::extra1) return "BTN_TRIGGER_HAPPY" + std::to_string(number_from(PadKey::extra1) + 1);
  if (key >= PadKey::button0 && key <= PadKey::button9) return "BTN_" + std::to_string(number_from(PadKey::button0));
  const auto named = std::find_if(k_named.begin(), k_named.end(), [key](const Named& one) { return one.key == key; });
  if (named != k_named.end()) return std::string(named->name);
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "0x%x", key_code(key));
  return text.data();
}

std::string key_names(const PadKeys& keys) {
  std::string names;
  keys.for_each([&names](PadKey key) {
    if (!names.empty()) names += '+';
    names += key_name(key);
  });
  return names.empty() ? "-" : names;
}

}  // namespace penpose::decode
