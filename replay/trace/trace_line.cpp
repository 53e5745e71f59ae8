#include "replay/trace/trace_line.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"

namespace penpose::replay {
namespace {

constexpr std::int64_t k_micros = 1000000;
constexpr std::int64_t k_latest_second = 9'000'000'000'000;  // keeps the sum of seconds and microseconds within 64 bits
/// A report or descriptor that claims more is not from a HID device.
constexpr std::uint64_t k_most_bytes = 65536;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Cuts the next word off the front of `rest`; empty at the end.
std::string_view next_word(std::string_view& rest) {
  std::size_t start = 0;
  while (start < rest.size() && is_blank(rest[start])) ++start;
  std::size_t end = start;
  while (end < rest.size() && !is_blank(rest[end])) ++end;
  const std::string_view word = rest.substr(start, end - start);
  rest.remove_prefix(end);
  return word;
}

std::optional<std::uint64_t> decimal(std::string_view word) {
  if (word.empty() || word.size() > 15) return std::nullopt;
  std::uint64_t value = 0;
  for (const char c : word) {
    if (c < '0' || c > '9') return std::nullopt;
    value = value * 10 + static_cast<std::uint64_t>(c - '0');
  }
  return value;
}

std::optional<std::uint16_t> id(std::string_view word) {
  if (word.empty() || word.size() > 8) return std::nullopt;
  std::uint64_t value = 0;
  for (const char c : word) {
    const auto digit = base::hex_value(c);
    if (!digit) return std::nullopt;
    value = value * 16 + *digit;
  }
  if (value > 0xffff) return std::nullopt;
  return static_cast<std::uint16_t>(value);
}

/// "seconds.fraction" in microseconds; digits beyond the sixth are dropped.
std::optional<std::int64_t> timestamp(std::string_view word) {
  const std::size_t point = word.find('.');
  const auto seconds = decimal(word.substr(0, point));
  if (!seconds || static_cast<std::int64_t>(*seconds) > k_latest_second) return std::nullopt;
  std::int64_t micros = 0;
  if (point != std::string_view::npos) {
    const std::string_view fraction = word.substr(point + 1);
    std::int64_t unit = k_micros / 10;
    for (const char c : fraction) {
      if (c < '0' || c > '9') return std::nullopt;
      micros += (c - '0') * unit;
      unit /= 10;
    }
  }
  return static_cast<std::int64_t>(*seconds) * k_micros + micros;
}

/// A length and that many bytes in hexadecimal. Gives the problem, empty when there is none.
std::string_view counted_bytes(std::string_view rest, std::vector<std::uint8_t>& bytes) {
  bytes.clear();
  const auto count = decimal(next_word(rest));
  if (!count) return "has no length";
  if (*count > k_most_bytes) return "has a length beyond 65536 bytes";
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    if (word.size() != 2) return "has a byte that is not two hexadecimal digits";
    const auto high = base::hex_value(word[0]);
    const auto low = base::hex_value(word[1]);
    if (!high || !low) return "has a byte that is not two hexadecimal digits";
    if (bytes.size() == *count) return "has more bytes than its length says";
    bytes.push_back(static_cast<std::uint8_t>(*high * 16 + *low));
  }
  if (bytes.size() < *count) return "has fewer bytes than its length says";
  return {};
}

void append_number(std::string& out, std::uint64_t value, int digits) {
  std::array<char, 20> buffer;
  std::size_t at = buffer.size();
  do {
    buffer[--at] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value > 0);
  out.append(static_cast<std::size_t>(std::max(0, digits - static_cast<int>(buffer.size() - at))), '0');
  out.append(&buffer[at], buffer.size() - at);
}

void append_id(std::string& out, std::uint16_t value, const TraceStyle& style) {
  base::append_hex(out, value, 4, style.upper_case_ids ? base::HexCase::upper : base::HexCase::lower);
}

void append_bytes(std::string& out, std::size_t length, base::Bytes bytes) {
  append_number(out, length, 1);
  for (const std::uint8_t byte : bytes) {
    out += ' ';
    base::append_hex(out, byte, 2);
  }
}

void end_line(std::string& out, const TraceStyle& style) { out += style.carriage_return ? "\r\n" : "\n"; }

constexpr std::string_view k_string_begins = "# string ";

/// # string INDEX: "TEXT", where TEXT may have quotes. Anything else is a comment.
void read_string(std::string_view text, TraceLine& line) {
  const std::size_t colon = text.find(": \"", k_string_begins.size());
  if (colon == std::string_view::npos || text.back() != '"' || text.size() < colon + 4) return;
  const auto index = decimal(text.substr(k_string_begins.size(), colon - k_string_begins.size()));
  if (!index || *index > 255) return;
  line.kind = TraceLineKind::string;
  line.index = static_cast<int>(*index);
  line.value = text.substr(colon + 3, text.size() - colon - 4);
}

/// Text that ends where a line would break.
std::string_view one_line(std::string_view text) { return text.substr(0, text.find_first_of("\r\n")); }

}  // namespace

TraceLine parse_trace_line(std::string_view text, std::vector<std::uint8_t>& bytes) {
  TraceLine line;
  line.text = text;
  if (text.starts_with(k_string_begins)) {
    read_string(text, line);
    return line;
  }
  if (text.size() < 2 || text[1] != ':') return line;
  std::string_view rest = text.substr(2);
  const auto accept = [&](TraceLineKind kind, std::string_view problem) {
    line.problem = problem;
    if (problem.empty()) line.kind = kind;
  };
  switch (text[0]) {
    case 'D': {
      const auto device = decimal(next_word(rest));
      const bool fits = device && *device <= 9999 && next_word(rest).empty();
      if (fits) line.device = static_cast<int>(*device);
      accept(TraceLineKind::device, fits ? "" : "has no device number");
      break;
    }
    case 'R':
      accept(TraceLineKind::descriptor, counted_bytes(rest, bytes));
      line.bytes = bytes;
      break;
    case 'N':
    case 'P':
      line.value = base::trim(rest);
      accept(text[0] == 'N' ? TraceLineKind::name : TraceLineKind::physical, {});
      break;
    case 'I': {
      const auto bus = id(next_word(rest));
      const auto vendor = id(next_word(rest));
      const auto product = id(next_word(rest));
      if (bus && vendor && product) {
        line.bus = *bus;
        line.vendor = *vendor;
        line.product = *product;
      }
      accept(TraceLineKind::identity, bus && vendor && product ? "" : "is not bus, vendor and product");
      break;
    }
    case 'E': {
      const auto time = timestamp(next_word(rest));
      if (!time) {
        line.problem = "has no time";
        break;
      }
      line.time_us = *time;
      accept(TraceLineKind::report, counted_bytes(rest, bytes));
      line.bytes = bytes;
      break;
    }
    default:
      break;
  }
  return line;
}

void append_device(std::string& out, int device, const TraceStyle& style) {
  out += style.blank_after_device ? "D: " : "D:";
  append_number(out, static_cast<std::uint64_t>(std::max(device, 0)), 1);
  end_line(out, style);
}

void append_descriptor(std::string& out, base::Bytes descriptor, const TraceStyle& style) {
  out += "R: ";
  append_bytes(out, descriptor.size(), descriptor);
  end_line(out, style);
}

void append_name(std::string& out, std::string_view name, const TraceStyle& style) {
  out += "N: ";
  out += one_line(name);
  end_line(out, style);
}

void append_physical(std::string& out, std::string_view path, const TraceStyle& style) {
  out += "P: ";
  out += one_line(path);
  end_line(out, style);
}

void append_identity(std::string& out, std::uint16_t bus, std::uint16_t vendor, std::uint16_t product,
                     const TraceStyle& style) {
  out += "I: ";
  // The bus stands without leading zeros.
  std::string digits;
  append_id(digits, bus, style);
  out += digits.substr(std::min<std::size_t>(digits.find_first_not_of('0'), 3));
  out += ' ';
  append_id(out, vendor, style);
  out += ' ';
  append_id(out, product, style);
  end_line(out, style);
}

void append_report(std::string& out, std::int64_t time_us, base::Bytes report, const TraceStyle& style) {
  append_cut_report(out, time_us, report.size(), report, style);
}

void append_cut_report(std::string& out, std::int64_t time_us, std::size_t length, base::Bytes first,
                       const TraceStyle& style) {
  const auto time = static_cast<std::uint64_t>(std::max<std::int64_t>(time_us, 0));
  out += "E: ";
  append_number(out, time / k_micros, style.second_digits);
  out += '.';
  append_number(out, time % k_micros, 6);
  out += ' ';
  append_bytes(out, length, first);
  end_line(out, style);
}

void append_string(std::string& out, int index, std::string_view text, const TraceStyle& style) {
  append_comment(out, std::string(k_string_begins.substr(2)) + std::to_string(index) + ": \"" + std::string(text) + '"',
                 style);
}

void append_comment(std::string& out, std::string_view text, const TraceStyle& style) {
  out += "# ";
  for (const char c : text) out += c == '\n' || c == '\r' ? ' ' : c;
  end_line(out, style);
}

void append_line(std::string& out, const TraceLine& line) {
  out += line.text;
  out += line.end;
}

}  // namespace penpose::replay
