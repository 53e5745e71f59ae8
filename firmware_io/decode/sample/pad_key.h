#pragma once

#include <cstdint>
#include <string>

namespace penpose::decode {

/// The keys that a pad may have, in the order of Linux's key codes (input-event-codes.h), which is the order in which
/// they are listed and drawn. Most keys of tablets are numbered; those with a fixed meaning have a name.
enum class PadKey : std::uint8_t {
  // clang-format off
  program1, program2, program3,
  button0, button1, button2, button3, button4, button5, button6, button7, button8, button9,
  left, right, forward, back,
  base, base2, base3, base4, base5, base6,
  a, b, c, x, y, z,
  info, button_config, control_panel, screen_keyboard,
  extra1,  ///< 24 more, for pads with more than 22 keys
  // clang-format on
};

inline constexpr unsigned k_extra_keys = 24;
inline constexpr unsigned k_pad_keys = static_cast<unsigned>(PadKey::extra1) + k_extra_keys;
static_assert(k_pad_keys <= 64, "a set of keys is a mask of 64 bits");

/// A set of keys: bit i is the i-th of PadKey.
using PadKeys = std::uint64_t;

[[nodiscard]] constexpr PadKeys key_bit(PadKey key) { return PadKeys{1} << static_cast<unsigned>(key); }

/// How many keys can be numbered.
inline constexpr unsigned k_numbered_keys = 22 + k_extra_keys;

/// Linux's key for the tablet's key `number` (0-based, below k_numbered_keys): BTN_0 to BTN_9, then BTN_A
/// to BTN_Z, then BTN_BASE and on.
[[nodiscard]] constexpr PadKey numbered_key(unsigned number) {
  const auto from = [](PadKey first, unsigned by) { return static_cast<PadKey>(static_cast<unsigned>(first) + by); };
  if (number < 10) return from(PadKey::button0, number);
  if (number < 16) return from(PadKey::a, number - 10);
  if (number < 22) return from(PadKey::base, number - 16);
  return from(PadKey::extra1, number - 22);
}

/// The keys that are down among the first `count` numbered ones: bit i of `pressed` is key i.
[[nodiscard]] PadKeys numbered_keys(std::uint64_t pressed, unsigned count);

/// Linux's code of a key.
[[nodiscard]] std::uint16_t key_code(PadKey key);

/// Linux's name of a key, such as `BTN_0` or `KEY_PROG1`; for keys that most name tables lack, the code
/// (`0x166`).
[[nodiscard]] std::string key_name(PadKey key);

/// The names of a set in the order of their codes, joined by `+`; `-` for none.
[[nodiscard]] std::string key_names(PadKeys keys);

}  // namespace penpose::decode
