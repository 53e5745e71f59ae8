#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

namespace penpose::decode {

/// How many codes of Linux from BTN_0 on a pad's key may have: BTN_MISC to BTN_WHEEL, which pads that describe their
/// keys may number through.
inline constexpr unsigned k_button_codes = 0x52;
inline constexpr unsigned k_extra_keys = 24;

/// The keys that a pad may have, in the order of Linux's key codes (input-event-codes.h), which is the order in which
/// they are listed and drawn. Most keys of tablets are numbered; those with a fixed meaning have a name. Of the codes
/// from `button0` on, also those without a name are keys.
enum class PadKey : std::uint8_t {
  // clang-format off
  program1, program2, program3,
  button0, button1, button2, button3, button4, button5, button6, button7, button8, button9,
  left = button0 + 0x10, right, middle, side, mouse_extra, forward, back,
  base = button0 + 0x26, base2, base3, base4, base5, base6,
  a = button0 + 0x30, b, c, x, y, z,
  stylus = button0 + 0x4b, stylus2,
  info = button0 + k_button_codes, button_config, control_panel, screen_keyboard,
  extra1,  ///< 24 more, for pads with more than 22 keys
  // clang-format on
};

inline constexpr unsigned k_pad_keys = static_cast<unsigned>(PadKey::extra1) + k_extra_keys;

/// A set of keys.
class PadKeys {
 public:
  constexpr PadKeys() = default;
  constexpr PadKeys(std::initializer_list<PadKey> keys) {
    for (const PadKey key : keys) set(key);
  }

  [[nodiscard]] constexpr bool has(PadKey key) const { return (word(key) >> bit(key) & 1) != 0; }
  constexpr void set(PadKey key, bool on = true) {
    const std::uint64_t mask = std::uint64_t{1} << bit(key);
    word(key) = on ? word(key) | mask : word(key) & ~mask;
  }
  [[nodiscard]] constexpr bool empty() const { return *this == PadKeys{}; }
  [[nodiscard]] constexpr unsigned count() const {
    unsigned keys = 0;
    for (const std::uint64_t one : words_) keys += static_cast<unsigned>(std::popcount(one));
    return keys;
  }
  /// Calls `each` with every key of the set, in order.
  template <typename Each>
  constexpr void for_each(Each each) const {
    for (unsigned i = 0; i < words_.size(); ++i) {
      for (std::uint64_t left = words_[i]; left != 0; left &= left - 1)
        each(static_cast<PadKey>(64 * i + static_cast<unsigned>(std::countr_zero(left))));
    }
  }

  constexpr PadKeys& operator|=(const PadKeys& other) {
    return combine(other, [](auto a, auto b) { return a | b; });
  }
  constexpr PadKeys& operator&=(const PadKeys& other) {
    return combine(other, [](auto a, auto b) { return a & b; });
  }
  constexpr PadKeys& operator^=(const PadKeys& other) {
    return combine(other, [](auto a, auto b) { return a ^ b; });
  }
  /// Without the keys of the other set.
  constexpr PadKeys& operator-=(const PadKeys& other) {
    return combine(other, [](auto a, auto b) { return a & ~b; });
  }
  friend constexpr PadKeys operator|(PadKeys a, const PadKeys& b) { return a |= b; }
  friend constexpr PadKeys operator&(PadKeys a, const PadKeys& b) { return a &= b; }
  friend constexpr PadKeys operator^(PadKeys a, const PadKeys& b) { return a ^= b; }
  friend constexpr PadKeys operator-(PadKeys a, const PadKeys& b) { return a -= b; }
  friend constexpr bool operator==(const PadKeys&, const PadKeys&) = default;

 private:
  template <typename Join>
  constexpr PadKeys& combine(const PadKeys& other, Join join) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] = join(words_[i], other.words_[i]);
    return *this;
  }
  static constexpr unsigned bit(PadKey key) { return static_cast<unsigned>(key) % 64; }
  constexpr std::uint64_t& word(PadKey key) { return words_[static_cast<std::size_t>(key) / 64]; }
  [[nodiscard]] constexpr std::uint64_t word(PadKey key) const { return words_[static_cast<std::size_t>(key) / 64]; }

  std::array<std::uint64_t, (k_pad_keys + 63) / 64> words_{};
};

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
/// The key with a code of Linux; nothing where pads have none.
[[nodiscard]] std::optional<PadKey> key_with_code(std::uint32_t code);

/// Linux's name of a key, such as `BTN_0` or `KEY_PROG1`; for keys that most name tables lack, the code
/// (`0x166`).
[[nodiscard]] std::string key_name(PadKey key);

/// The names of a set in the order of their codes, joined by `+`; `-` for none.
[[nodiscard]] std::string key_names(const PadKeys& keys);

}  // namespace penpose::decode
