#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace penpose::replay {

/// A report or descriptor that claims more is not from a HID device.
inline constexpr std::size_t k_most_report_bytes = 65536;

/// A line of a trace that its reader leaves out with a note, in the place of a report whose bytes are damaged.
inline constexpr std::string_view k_unreadable_line = "E: 0.000000 1 ??\n";

/// Cuts the next word, between blanks and tabs, off the front of `rest`; empty at the end.
[[nodiscard]] std::string_view next_word(std::string_view& rest);

/// A number of decimal digits alone, at most `most`.
[[nodiscard]] std::optional<std::uint64_t> decimal_number(std::string_view text, std::uint64_t most);

/// A number of 1 to 4 hexadecimal digits alone, as vendor and product ids are.
[[nodiscard]] std::optional<std::uint16_t> usb_id(std::string_view text);

/// "VVVV:PPPP".
struct UsbIds {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
};
[[nodiscard]] std::optional<UsbIds> usb_ids(std::string_view text);

/// Appends the bytes of words of two hexadecimal digits; false where a word is none, or where `bytes` would grow beyond
/// k_most_report_bytes: then those before it were appended.
[[nodiscard]] bool append_hex_words(std::string_view words, std::vector<std::uint8_t>& bytes);

}  // namespace penpose::replay
