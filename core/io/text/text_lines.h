#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

/// Walks over the lines of a text file, whose ends may be LF, CR LF or CR.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : text_(text) {}

  /// The next line without its end; nothing at the end of the text.
  std::optional<std::string_view> next();
  /// The next line that holds something after a comment, from '#' on, and blanks are cut away.
  std::optional<std::string_view> next_content();
  /// The number of the line that was given last, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// What follows the line that was given last.
  [[nodiscard]] std::string_view rest() const { return text_; }

  [[nodiscard]] base::Error error(std::string what, std::string remedy) const;

 private:
  std::string_view text_;
  std::size_t number_ = 0;
};

/// The text of a file from its first letter on, without a byte order mark and blank lines in front.
[[nodiscard]] std::string_view first_text(base::Bytes bytes);

/// Takes the first word, up to a blank or tab, off the line; empty at its end.
[[nodiscard]] std::string_view take_word(std::string_view& line);

/// A coordinate: a finite number that fits a float.
[[nodiscard]] std::optional<double> parse_coordinate(std::string_view word);

}  // namespace penpose::io
