#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace penpose::io {

/// Walks over numbers as SVG writes them (SVG 1.1, section 8.3.9): between two stand blanks, a comma, or nothing where
/// a sign or a point begins the next one.
class NumberScanner {
 public:
  explicit NumberScanner(std::string_view text) : text_(text) {}

  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
  [[nodiscard]] std::size_t offset() const { return at_; }
  /// What comes next; a zero byte at the end.
  [[nodiscard]] char peek() const { return at_end() ? '\0' : text_[at_]; }
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

  void skip_blanks();
  /// Blanks with at most one comma among them.
  void skip_separator();
  /// Takes the character where it comes next.
  bool take(char wanted);
  /// Takes letters; nothing else moves.
  std::string_view take_letters();
  /// The finite number that comes next; nothing where there is none.
  std::optional<double> number();
  /// The flag of an arc, one character that is 0 or 1.
  std::optional<bool> flag();
  /// Whether a number may begin here.
  [[nodiscard]] bool before_number() const;

 private:
  void skip_digits();

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace penpose::io
