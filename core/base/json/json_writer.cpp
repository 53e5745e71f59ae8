#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/json/json_value.h"
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

class Writer {
 public:
  Writer(std::string& out, int indent, bool as_made) : out_(out), indent_(indent), as_made_(as_made) {}

  void write(const Json& value, std::size_t level) {
    switch (value.type()) {
      case Json::value_t::boolean:
        out_ += value.get<bool>() ? "true" : "false";
        return;
      case Json::value_t::number_integer:
        out_ += std::to_string(value.get<std::int64_t>());
        return;
      case Json::value_t::number_unsigned:
        out_ += std::to_string(value.get<std::uint64_t>());
        return;
      case Json::value_t::number_float:
        append_real(out_, value.get<double>());
        return;
      case Json::value_t::string:
        append_text(out_, value.get_ref<const std::string&>());
        return;
      case Json::value_t::array:
        list_all('[', value.get_ref<const Json::array_t&>(), ']', level,
                 [&](const Json& entry) { write(entry, level + 1); });
        return;
      case Json::value_t::object:
        if (as_made_) {
          list_all('{', members_as_made(value), '}', level, [&](const auto* member) { write(*member, level + 1); });
        } else {
          list_all('{', value.get_ref<const Json::object_t&>(), '}', level,
                   [&](const auto& member) { write(member, level + 1); });
        }
        return;
      default:
        out_ += "null";
    }
  }

 private:
  void write(const Json::object_t::value_type& member, std::size_t level) {
    append_text(out_, member.first);
    out_ += indent_ >= 0 ? ": " : ":";
    write(static_cast<const Json&>(member.second), level);
  }
  /// What stands between brackets; `each` writes one entry.
  template <typename Entries, typename Each>
  void list_all(char opening, const Entries& entries, char closing, std::size_t level, const Each& each) {
    out_ += opening;
    bool first = true;
    for (const auto& entry : entries) {
      if (!first) out_ += ',';
      first = false;
      begin_line(level + 1);
      each(entry);
    }
    if (!first) begin_line(level);
    out_ += closing;
  }
  void begin_line(std::size_t deep) {
    if (indent_ >= 0) out_.append(1, '\n').append(deep * static_cast<std::size_t>(indent_), ' ');
  }

  std::string& out_;
  int indent_;
  bool as_made_;
};

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

std::string dump(const Json& value, int indent) {
  std::string out;
  Writer(out, indent, false).write(value, 0);
  return out;
}

std::string dump_as_made(const Json& value, int indent) {
  std::string out;
  Writer(out, indent, true).write(value, 0);
  return out;
}

}  // namespace penpose::json
