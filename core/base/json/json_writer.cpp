#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/json/json.h"
#include "core/base/text/letters.h"
#include "core/base/text/utf8.h"

namespace penpose::json {
namespace {

/// The shortest digits that read back as the same double, always with a point or an exponent, so that they are read
/// back as a double too: 2.0, 1e-07, 1.5e+300.
void append_real(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific).ptr;
  std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  if (text.starts_with('-')) {
    out += '-';
    text.remove_prefix(1);
  }
  const auto power = text.find('e');
  const std::string_view exponent = text.substr(power + 1);
  std::string digits(1, text[0]);
  if (power > 2) digits.append(text.substr(2, power - 2));
  int point = 0;  // where it stands in the digits
  std::from_chars(exponent.data() + 1, exponent.data() + exponent.size(), point);
  point = (exponent.starts_with('-') ? -point : point) + 1;
  const auto count = static_cast<int>(digits.size());
  constexpr int k_most_zeros = 4;
  constexpr int k_most_digits = 15;
  if (point > -k_most_zeros && point <= 0) {
    out.append("0.").append(static_cast<std::size_t>(-point), '0').append(digits);
  } else if (point > 0 && point <= k_most_digits) {
    const auto whole = static_cast<std::size_t>(point);
    if (count <= point) {
      out.append(digits).append(whole - digits.size(), '0').append(".0");
    } else {
      out.append(digits, 0, whole).append(1, '.').append(digits, whole);
    }
  } else {
    out += digits[0];
    if (count > 1) out.append(1, '.').append(digits, 1);
    out.append(1, 'e').append(exponent);
  }
}

/// A character of ASCII that JSON does not let stand, or that steers a terminal.
void append_escaped(std::string& out, unsigned char c) {
  constexpr std::string_view k_meant = "\"\\\b\f\n\r\t";
  constexpr std::string_view k_letters = "\"\\bfnrt";
  const auto found = k_meant.find(static_cast<char>(c));
  if (found != std::string_view::npos) {
    out.append(1, '\\').append(1, k_letters[found]);
  } else {
    out += "\\u";
    base::append_hex(out, c, 4);
  }
}

}  // namespace

void append_text(std::string& out, std::string_view text) {
  out += '"';
  while (!text.empty()) {
    const auto c = static_cast<unsigned char>(text[0]);
    std::size_t length = base::utf8_sequence_length(text);
    if (length == 0) {
      out += "\xef\xbf\xbd";
      length = std::max<std::size_t>(1, base::utf8_begun(text));
    } else if (c < 0x20 || c == 0x7f || c == '"' || c == '\\') {
      append_escaped(out, c);
    } else if (c == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0) {
      append_escaped(out, static_cast<unsigned char>(text[1]));
    } else {
      // Most are names, and need nothing done to them.
      while (length < text.size() && text[length] >= 0x20 && text[length] < 0x7f && text[length] != '"' &&
             text[length] != '\\') {
        ++length;
      }
      out += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  out += '"';
}

std::string Json::dump(int indent, char, bool, error_handler_t) const {
  std::string out;
  write(out, indent, 0, Order::by_name);
  return out;
}

std::string Json::dump_as_made(int indent) const {
  std::string out;
  write(out, indent, 0, Order::as_made);
  return out;
}

void Json::write(std::string& out, int indent, std::size_t level, Order order) const {
  const auto line = [&](std::size_t deep) {
    if (indent >= 0) out.append(1, '\n').append(deep * static_cast<std::size_t>(indent), ' ');
  };
  // What stands between brackets; `each` writes one entry.
  const auto list_all = [&](char opening, const auto& entries, char closing, const auto& each) {
    out += opening;
    bool first = true;
    for (const auto& entry : entries) {
      if (!first) out += ',';
      first = false;
      line(level + 1);
      each(entry);
    }
    if (!first) line(level);
    out += closing;
  };
  const auto write_member = [&](const object_t::value_type& member) {
    append_text(out, member.first);
    out += indent >= 0 ? ": " : ":";
    member.second.write(out, indent, level + 1, order);
  };
  switch (type_) {
    case value_t::boolean:
      out += held_.boolean ? "true" : "false";
      return;
    case value_t::number_integer:
      out += std::to_string(held_.integer);
      return;
    case value_t::number_unsigned:
      out += std::to_string(held_.natural);
      return;
    case value_t::number_float:
      append_real(out, held_.real);
      return;
    case value_t::string:
      append_text(out, *held_.text);
      return;
    case value_t::array:
      list_all('[', *held_.list, ']', [&](const Json& entry) { entry.write(out, indent, level + 1, order); });
      return;
    case value_t::object:
      if (order == Order::by_name) {
        list_all('{', *held_.members, '}', write_member);
      } else {
        list_all('{', members_as_made(), '}', [&](const auto* member) { write_member(*member); });
      }
      return;
    default:
      out += "null";
  }
}

}  // namespace penpose::json
