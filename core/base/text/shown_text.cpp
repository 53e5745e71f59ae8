#include "core/base/text/shown_text.h"

#include <cstdint>

#include "core/base/text/letters.h"
#include "core/base/text/utf8.h"

namespace penpose::base {
namespace {

constexpr std::string_view k_gap = "...";

std::uint32_t code_point(std::string_view sequence) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(sequence[i]); };
  if (sequence.size() == 1) return byte(0);
  std::uint32_t code = byte(0) & (0xffU >> (sequence.size() + 1));
  for (std::size_t i = 1; i < sequence.size(); ++i) code = (code << 6) | (byte(i) & 0x3fU);
  return code;
}

/// Control characters (C0, DEL, C1), breaks of lines and paragraphs, marks that turn the direction of writing, and what
/// takes no place: a name could hide something, or be taken for another one.
bool is_hidden(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0xad || code == 0x61c || code == 0x180e ||
         (code >= 0x200b && code <= 0x200f) || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2060 && code <= 0x206f) || code == 0xfeff || (code >= 0xfff0 && code <= 0xfffb) ||
         (code >= 0xe0000 && code <= 0xe007f);
}

void append_code(std::string& text, std::uint32_t value) {
  std::size_t digits = value > 0xff ? 8 : 2;
  while (digits > 2 && (value >> (4 * (digits - 1))) == 0) --digits;
  append_hex(text, value, digits);
}

/// One character of the name, as it may be printed. Takes it off the name.
std::string take_shown(std::string_view& name) {
  const std::size_t length = utf8_sequence_length(name);
  const std::string_view sequence = name.substr(0, length == 0 ? 1 : length);
  const std::uint32_t code = code_point(sequence);
  name.remove_prefix(sequence.size());
  if (length > 0 && !is_hidden(code)) return std::string(sequence);
  std::string text;
  if (sequence.size() == 1) {
    text = "\\x";
    append_code(text, code);
  } else {
    text = "\\u{";
    append_code(text, code);
    text += '}';
  }
  return text;
}

}  // namespace

std::string shown_name(std::string_view name, std::size_t most) {
  if (name.size() > 4 * most) {
    // Only its ends are looked at; a sequence that is cut there shows as bytes.
    const std::string ends = std::string(name.substr(0, 2 * most)) + std::string(name.substr(name.size() - 2 * most));
    return shown_name(ends, most);
  }
  std::string text;
  std::string head;
  while (!name.empty()) {
    text += take_shown(name);
    if (text.size() + k_gap.size() <= most * 2 / 3) head = text;
  }
  if (text.size() <= most) return text;
  std::size_t tail = text.size() - (most - head.size() - k_gap.size());
  while (tail < text.size() && (static_cast<std::uint8_t>(text[tail]) & 0xc0) == 0x80) ++tail;
  return head + std::string(k_gap) + text.substr(tail);
}

std::string shown_line(std::string_view text, std::size_t most) {
  std::string line(text);
  for (char& c : line) {
    if (c == '\n' || c == '\r' || c == '\t' || c == '\v' || c == '\f') c = ' ';
  }
  return shown_name(line, most);
}

}  // namespace penpose::base
