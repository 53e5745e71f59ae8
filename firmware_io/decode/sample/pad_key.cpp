#include "firmware_io/decode/sample/pad_key.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <string_view>

namespace penpose::decode {
namespace {

struct Named {
  std::uint16_t code;
  std::string_view name;
};

// Source: Linux, include/uapi/linux/input-event-codes.h.
constexpr auto k_named = std::to_array<Named>({
    {148, "KEY_PROG1"},
    {149, "KEY_PROG2"},
    {202, "KEY_PROG3"},
    {0x100, "BTN_0"},
    {0x101, "BTN_1"},
    {0x102, "BTN_2"},
    {0x103, "BTN_3"},
    {0x104, "BTN_4"},
    {0x105, "BTN_5"},
    {0x106, "BTN_6"},
    {0x107, "BTN_7"},
    {0x108, "BTN_8"},
    {0x109, "BTN_9"},
    {0x110, "BTN_LEFT"},
    {0x111, "BTN_RIGHT"},
    {0x115, "BTN_FORWARD"},
    {0x116, "BTN_BACK"},
    {0x126, "BTN_BASE"},
    {0x127, "BTN_BASE2"},
    {0x128, "BTN_BASE3"},
    {0x129, "BTN_BASE4"},
    {0x12a, "BTN_BASE5"},
    {0x12b, "BTN_BASE6"},
    {0x130, "BTN_A"},
    {0x131, "BTN_B"},
    {0x132, "BTN_C"},
    {0x133, "BTN_X"},
    {0x134, "BTN_Y"},
    {0x135, "BTN_Z"},
    {0x166, ""},
    {0x240, "KEY_BUTTONCONFIG"},
    {0x243, "KEY_CONTROLPANEL"},
    {0x278, "KEY_ONSCREEN_KEYBOARD"},
});
static_assert(k_named.size() == static_cast<std::size_t>(PadKey::extra1));

constexpr std::uint16_t k_first_extra = 0x2c0;  // BTN_TRIGGER_HAPPY1

}  // namespace

PadKeys numbered_keys(std::uint64_t pressed, unsigned count) {
  PadKeys keys = 0;
  for (unsigned i = 0; i < std::min(count, k_numbered_keys); ++i) {
    if ((pressed >> i & 1) != 0) keys |= key_bit(numbered_key(i));
  }
  return keys;
}

std::uint16_t key_code(PadKey key) {
  const auto index = static_cast<std::size_t>(key);
  if (index < k_named.size()) return k_named[index].code;
  return static_cast<std::uint16_t>(k_first_extra + (index - k_named.size()));
}

std::string key_name(PadKey key) {
  const auto index = static_cast<std::size_t>(key);
  if (index >= k_named.size()) return "BTN_TRIGGER_HAPPY" + std::to_string(index - k_named.size() + 1);
  if (!k_named[index].name.empty()) return std::string(k_named[index].name);
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "0x%x", k_named[index].code);
  return text.data();
}

std::string key_names(PadKeys keys) {
  std::string names;
  for (; keys != 0; keys &= keys - 1) {
    if (!names.empty()) names += '+';
    names += key_name(static_cast<PadKey>(std::countr_zero(keys)));
  }
  return names.empty() ? "-" : names;
}

}  // namespace penpose::decode
