#include "firmware_io/event/evemu_line.h"

#include <algorithm>
#include <charconv>
#include <linux/input-event-codes.h>

namespace penpose::event {
namespace {

constexpr std::int64_t k_micros = 1'000'000;
constexpr std::int64_t k_latest_second = 9'000'000'000'000;
constexpr int k_decimal = 10;
constexpr int k_hex = 16;

std::string_view next_word(std::string_view& rest) {
  const std::size_t begin = std::min(rest.find_first_not_of(" \t"), rest.size());
  const std::size_t end = std::min(rest.find_first_of(" \t", begin), rest.size());
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

template <typename Number>
std::optional<Number> number(std::string_view word, int base) {
  Number value{};
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value, base);
  if (word.empty() || read.ec != std::errc() || read.ptr != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace

bool EvemuLines::marks(std::string_view line) { return line.starts_with("# EVEMU 1."); }

bool EvemuLines::read_ids(std::string_view words) {
  for (std::uint16_t* id : {&axes_.bus, &axes_.vendor, &axes_.product}) {
    const auto value = number<std::uint16_t>(next_word(words), k_hex);
    if (!value) return false;
    *id = *value;
  }
  return true;
}

/// Bytes of a bit map, the lowest bit first; several lines of one type go on with each other.
bool EvemuLines::read_bits(std::string_view words, bool properties) {
  std::uint16_t type = 0;
  if (!properties) {
    const auto named = number<std::uint16_t>(next_word(words), k_hex);
    if (!named) return false;
    type = *named;
    if (type != bits_type_) next_bit_ = 0;
    bits_type_ = type;
  }
  std::uint32_t& bit = properties ? next_property_ : next_bit_;
  for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
    const auto byte = number<std::uint8_t>(word, k_hex);
    if (!byte || bit > KEY_MAX) return false;
    for (unsigned i = 0; i < 8; ++i, ++bit) {
      if ((*byte >> i & 1) == 0) continue;
      const auto code = static_cast<std::uint16_t>(bit);
      if (properties) {
        axes_.properties.insert(code);
      } else if (type == EV_KEY) {
        axes_.keys.insert(code);
      } else if (type == EV_REL) {
        axes_.rels.insert(code);
      } else if (type == EV_MSC) {
        axes_.mscs.insert(code);
      } else if (type == EV_ABS && code <= ABS_MAX) {
        axes_.abs.try_emplace(code);
      }
    }
  }
  return true;
}

/// Minimum, maximum, the kernel's filter, the flat middle, and since 1.1 the resolution.
bool EvemuLines::read_range(std::string_view words) {
  const auto code = number<std::uint16_t>(next_word(words), k_hex);
  const auto minimum = number<std::int32_t>(next_word(words), k_decimal);
  const auto maximum = number<std::int32_t>(next_word(words), k_decimal);
  next_word(words);
  next_word(words);
  if (!code || *code > ABS_MAX || !minimum || !maximum) return false;
  axes_.abs[*code] = {*minimum, *maximum, number<std::int32_t>(next_word(words), k_decimal).value_or(0)};
  return true;
}

bool EvemuLines::read_event(std::string_view words) {
  const std::string_view time = next_word(words);
  const std::size_t point = time.find('.');
  if (point == std::string_view::npos || time.size() - point != 7) return false;
  const auto seconds = number<std::int64_t>(time.substr(0, point), k_decimal);
  const auto micros = number<std::uint32_t>(time.substr(point + 1), k_decimal);
  const auto type = number<std::uint16_t>(next_word(words), k_hex);
  const auto code = number<std::uint16_t>(next_word(words), k_hex);
  const auto value = number<std::int32_t>(next_word(words), k_decimal);
  if (!seconds || *seconds < 0 || *seconds > k_latest_second || !micros || !type || !code || !value) return false;
  event_ = {*type, *code, *value};
  time_us_ = *seconds * k_micros + *micros;
  return true;
}

EvemuLines::Kind EvemuLines::read(std::string_view line) {
  if (line.size() < 2 || line[1] != ':') return Kind::other;
  const std::string_view rest = line.substr(2);
  bool whole = true;
  switch (line[0]) {
    case 'N':
      axes_.name = rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
      break;
    case 'I':
      whole = read_ids(rest);
      break;
    case 'P':
    case 'B':
      whole = read_bits(rest, line[0] == 'P');
      break;
    case 'A':
      whole = read_range(rest);
      break;
    case 'E':
      return read_event(rest) ? Kind::event : Kind::broken;
    default:
      return Kind::other;
  }
  return whole ? Kind::facts : Kind::broken;
}

}  // namespace penpose::event
