#include "replay/recording/decoration.h"

#include <algorithm>

#include "core/base/text/letters.h"
#include "replay/recording/byte_stream.h"

namespace penpose::replay {
namespace {

constexpr char k_escape = '\x1b';
constexpr char k_bell = '\x07';
constexpr std::string_view k_hard_blank = "\xC2\xA0";  // U+00A0, of pages

bool is_between(char c, char first, char last) { return c >= first && c <= last; }

/// Bytes of the escape sequence at the front of `text`, which begins with ESC (ECMA-48, section 5).
std::size_t escape_length(std::string_view text) {
  if (text.size() < 2) return text.size();
  const char kind = text[1];
  std::size_t at = 2;
  if (kind == '[') {
    while (at < text.size() && is_between(text[at], 0x20, 0x3f)) ++at;
    return std::min(at + 1, text.size());
  }
  if (kind == ']' || kind == 'P' || kind == 'X' || kind == '^' || kind == '_') {
    // A string, for instance of a window's title, ends with ESC \ or, as xterm has it, with BEL.
    for (; at < text.size(); ++at) {
      if (text[at] == k_bell) return at + 1;
      if (text[at] == k_escape && at + 1 < text.size() && text[at + 1] == '\\') return at + 2;
    }
    return text.size();
  }
  at = 1;
  while (at < text.size() && is_between(text[at], 0x20, 0x2f)) ++at;
  return std::min(at + 1, text.size());
}

/// Without escapes and control characters but tabs; what stands before a carriage return is overwritten by what
/// follows.
std::string without_controls(std::string_view line) {
  std::string out;
  bool returned = false;
  for (std::size_t i = 0; i < line.size();) {
    const char c = line[i];
    if (c == k_escape) {
      i += escape_length(line.substr(i));
      continue;
    }
    ++i;
    if (c == '\r') returned = true;
    if ((is_between(c, 0, 0x1f) && c != '\t') || c == 0x7f) continue;
    if (returned) out.clear();
    returned = false;
    out += c;
  }
  return out;
}

class Undecorator final : public LineConverter {
 public:
  base::Status line(std::string_view text, std::string& out) override {
    out += undecorated(text);
    out += '\n';
    return base::Done{};
  }
  void finish(std::string&) override {}
};

}  // namespace

std::string undecorated(std::string_view line) {
  const std::string plain = without_controls(base::without_mark(line));
  std::string_view text = plain;
  for (std::size_t before = 0; before != text.size();) {
    before = text.size();
    text.remove_prefix(std::min(text.find_first_not_of(" \t>"), text.size()));
    if (text.starts_with(k_hard_blank)) text.remove_prefix(k_hard_blank.size());
    text = base::without_mark(text);
  }
  return std::string(text);
}

ReadBytes without_decoration(ReadBytes read) { return convert_lines(std::move(read), std::make_shared<Undecorator>()); }

}  // namespace penpose::replay
