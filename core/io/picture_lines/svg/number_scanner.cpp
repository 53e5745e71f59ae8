#include "core/io/picture_lines/svg/internal/number_scanner.h"

#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"

namespace penpose::io {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_letter(char c) { return base::lower(c) >= 'a' && base::lower(c) <= 'z'; }

}  // namespace

void NumberScanner::skip_blanks() {
  while (is_blank(peek())) ++at_;
}

void NumberScanner::skip_separator() {
  skip_blanks();
  if (take(',')) skip_blanks();
}

bool NumberScanner::take(char wanted) {
  if (at_end() || text_[at_] != wanted) return false;
  ++at_;
  return true;
}

std::string_view NumberScanner::take_letters() {
  const std::size_t begin = at_;
  while (is_letter(peek())) ++at_;
  return text_.substr(begin, at_ - begin);
}

void NumberScanner::skip_digits() {
  while (is_digit(peek())) ++at_;
}

std::optional<double> NumberScanner::number() {
  const std::size_t begin = at_;
  if (peek() == '+' || peek() == '-') ++at_;
  skip_digits();
  if (take('.')) skip_digits();
  // An "e" without digits is the first letter of a unit.
  const std::size_t mantissa = at_;
  if (base::lower(peek()) == 'e') {
    ++at_;
    if (peek() == '+' || peek() == '-') ++at_;
    if (!is_digit(peek())) at_ = mantissa;
    skip_digits();
  }
  const auto value = base::parse_double(text_.substr(begin, at_ - begin));
  if (value && std::isfinite(*value)) return value;
  at_ = begin;
  return std::nullopt;
}

std::optional<bool> NumberScanner::flag() {
  if (take('0')) return false;
  if (take('1')) return true;
  return std::nullopt;
}

bool NumberScanner::before_number() const {
  const char c = peek();
  return is_digit(c) || c == '+' || c == '-' || c == '.';
}

}  // namespace penpose::io
