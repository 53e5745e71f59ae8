#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <vector>

#include "core/base/json/json_value.h"
#include "core/base/text/letters.h"
#include "core/base/text/utf16.h"
#include "core/base/text/utf8.h"

namespace penpose::json {
namespace {

enum class Token : std::uint8_t { begin_object, end_object, begin_array, end_array, colon, comma, scalar, text, end };

constexpr int k_end = -1;
constexpr bool is_digit(int c) { return c >= '0' && c <= '9'; }

/// Whether a number of JSON that no double holds is too large, not too small: by the place of its first digit.
bool is_too_large(std::string_view number) {
  constexpr std::int64_t k_far = 1'000'000'000'000;
  const auto power = number.find_first_of("eE");
  const auto digits = number.substr(0, power);
  const auto point = std::min(digits.find('.'), digits.size());
  const auto first = digits.find_first_of("123456789");
  if (first == std::string_view::npos) return false;
  std::int64_t exponent = 0;
  if (power != std::string_view::npos) {
    for (const char c : number.substr(power + 1)) {
      if (is_digit(c) && exponent < k_far) exponent = exponent * 10 + (c - '0');
    }
    if (number[power + 1] == '-') exponent = -exponent;
  }
  return static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) + exponent > 0;
}

/// Reads text as RFC 8259 says it. It keeps its own stack, so that no text makes it recurse, and what is read is in its
/// place at once, so that nothing is lost where memory runs out.
class Reader {
 public:
  Reader(std::string_view text, std::size_t deepest) : text_(text), deepest_(deepest) {}

  Json read() {
    Json root;
    skip_mark();
    token_ = next();
    for (Json* into = &root; into != nullptr; into = next_place()) fill(*into);
    if (next() != Token::end) fail();
    return root;
  }

 private:
  /// The value whose first token is token_.
  void fill(Json& into) {
    if (token_ == Token::begin_object || token_ == Token::begin_array) {
      if (open_.size() == deepest_) fail(Json::Fault::depth);
      into = token_ == Token::begin_object ? Json::object() : Json::array();
      open_.push_back(&into);
      fresh_ = true;
    } else if (token_ == Token::scalar) {
      into = std::move(scalar_);
    } else if (token_ == Token::text) {
      into = word_;
    } else {
      fail();
    }
  }

  /// Where the next value goes, whose first token is then token_; null where all is closed. Only the innermost
  /// container grows, so that pointers to those around it stay good.
  Json* next_place() {
    while (!open_.empty()) {
      Json& inner = *open_.back();
      token_ = next();
      if (token_ == (inner.is_array() ? Token::end_array : Token::end_object)) {
        open_.pop_back();
        fresh_ = false;
        continue;
      }
      if (!fresh_) {
        if (token_ != Token::comma) fail();
        token_ = next();
      }
      fresh_ = false;
      if (inner.is_array()) {
        inner.push_back(nullptr);
        return &inner[inner.size() - 1];
      }
      if (token_ != Token::text) fail();
      // Of two members of one name the last counts.
      Json& member = inner[word_];
      member = nullptr;
      if (next() != Token::colon) fail();
      token_ = next();
      return &member;
    }
    return nullptr;
  }

  Token next() {
    int c = get();
    while (c == ' ' || c == '\t' || c == '\n' || c == '\r') c = get();
    switch (c) {
      case '{':
        return Token::begin_object;
      case '}':
        return Token::end_object;
      case '[':
        return Token::begin_array;
      case ']':
        return Token::end_array;
      case ':':
        return Token::colon;
      case ',':
        return Token::comma;
      case '"':
        read_text();
        return Token::text;
      case 't':
        return literal("rue", true);
      case 'f':
        return literal("alse", false);
      case 'n':
        return literal("ull", nullptr);
      case '\0':  // what some programs fill a GLB's chunk up with
      case k_end:
        return Token::end;
      default:
        if (c != '-' && !is_digit(c)) fail();
        read_number(c);
        return Token::scalar;
    }
  }

  Token literal(std::string_view rest, Json value) {
    for (const char c : rest) {
      if (get() != c) fail();
    }
    scalar_ = std::move(value);
    return Token::scalar;
  }

  void read_number(int c) {
    const std::size_t begin = at_ - 1;
    const bool negative = c == '-';
    if (negative) c = get();
    if (!is_digit(c)) fail();
    if (c != '0') skip_digits();
    bool whole = true;
    if (peek() == '.') {
      whole = false;
      ++at_;
      read_digits();
    }
    if (peek() == 'e' || peek() == 'E') {
      whole = false;
      ++at_;
      if (peek() == '+' || peek() == '-') ++at_;
      read_digits();
    }
    const std::string_view number = text_.substr(begin, at_ - begin);
    if (whole && (negative ? holds<std::int64_t>(number) : holds<std::uint64_t>(number))) return;
    double value = 0;
    const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), value);
    const bool out_of_range = code != std::errc{} || std::isinf(value);
    if (out_of_range && is_too_large(number)) fail(Json::Fault::number);
    scalar_ = out_of_range ? (negative ? -0.0 : 0.0) : value;
  }
  template <typename Whole>
  bool holds(std::string_view number) {
    Whole value{};
    if (std::from_chars(number.data(), number.data() + number.size(), value).ec != std::errc{}) return false;
    scalar_ = value;
    return true;
  }
  void read_digits() {
    if (!is_digit(get())) fail();
    skip_digits();
  }
  void skip_digits() {
    while (is_digit(peek())) ++at_;
  }

  void read_text() {
    word_.clear();
    while (true) {
      const std::size_t begin = at_;
      while (at_ < text_.size() && is_plain(text_[at_])) ++at_;
      word_.append(text_.substr(begin, at_ - begin));
      const int c = get();
      if (c == '"') return;
      if (c == '\\') {
        read_escape();
      } else if (c >= 0x80) {
        read_sequence();
      } else {
        fail();
      }
    }
  }
  static bool is_plain(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x20 && byte < 0x80 && c != '"' && c != '\\';
  }

  /// One character that is not of ASCII, of which the first byte is read.
  void read_sequence() {
    const std::string_view rest = text_.substr(at_ - 1);
    const std::size_t length = base::utf8_sequence_length(rest);
    if (length == 0) {
      at_ += base::utf8_begun(rest);
      fail();
    }
    word_.append(rest.substr(0, length));
    at_ += length - 1;
  }

  void read_escape() {
    constexpr std::string_view k_letters = "\"\\/bfnrt";
    constexpr std::string_view k_meant = "\"\\/\b\f\n\r\t";
    const int c = get();
    if (c == 'u') {
      word_.append(base::utf8_of(read_code()));
      return;
    }
    const auto found = c == k_end ? std::string_view::npos : k_letters.find(static_cast<char>(c));
    if (found == std::string_view::npos) fail();
    word_ += k_meant[found];
  }
  /// Four digits, or of what takes two of them both.
  char32_t read_code() {
    const unsigned first = read_hex();
    if (base::is_low_half(first)) fail();
    if (!base::is_high_half(first)) return first;
    if (get() != '\\' || get() != 'u') fail();
    const unsigned second = read_hex();
    if (!base::is_low_half(second)) fail();
    return base::code_of_halves(first, second);
  }
  unsigned read_hex() {
    unsigned value = 0;
    for (int i = 0; i < 4; ++i) {
      const int c = get();
      const auto digit = c == k_end ? std::nullopt : base::hex_value(static_cast<char>(c));
      if (!digit) fail();
      value = value << 4 | *digit;
    }
    return value;
  }

  void skip_mark() {
    constexpr std::string_view k_mark = "\xef\xbb\xbf";
    if (!text_.starts_with(k_mark[0])) return;
    for (const char c : k_mark) {
      if (get() != static_cast<unsigned char>(c)) fail();
    }
  }

  int get() {
    if (at_ < text_.size()) return static_cast<unsigned char>(text_[at_++]);
    at_ = text_.size() + 1;
    return k_end;
  }
  [[nodiscard]] int peek() const { return at_ < text_.size() ? static_cast<unsigned char>(text_[at_]) : k_end; }
  [[noreturn]] void fail(Json::Fault fault = Json::Fault::text) const { throw Json::parse_error(at_, fault); }

  std::string_view text_;
  std::size_t deepest_;
  std::size_t at_ = 0;  ///< bytes read; the end of the text, once it is met, counts as one
  std::vector<Json*> open_;
  bool fresh_ = false;  ///< the innermost container was opened just now
  Token token_ = Token::end;
  std::string word_;  ///< of the last text
  Json scalar_;       ///< the last value that is neither text nor container
};

}  // namespace

Json Json::parse(std::string_view text, std::size_t deepest) { return Reader(text, deepest).read(); }

Json Json::parse(const char* first, const char* last, std::nullptr_t, bool throws) {
  try {
    return parse(std::string_view(first, static_cast<std::size_t>(last - first)));
  } catch (const parse_error&) {
    if (throws) throw;
    return nullptr;
  }
}

}  // namespace penpose::json
