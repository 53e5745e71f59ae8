#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/text/text_lines.h"

namespace penpose::io {

/// Walks over the rows of a table of numbers with a header line. Cells are separated by commas, or by semicolons or
/// tabs where the header has more of those; between semicolons and tabs a comma is a decimal point, as programs of some
/// countries write it. Blanks around cells and quotes around them are taken away; empty lines are skipped.
class CsvReader {
 public:
  /// `text` must outlive the reader. Errors: no header line.
  static base::Result<CsvReader> open(std::string_view text);
  /// A table without a header line: the names of its columns are given. Cells may be a blank apart, too. `names` must
  /// outlive the reader. Errors: no line.
  static base::Result<CsvReader> open_bare(std::string_view text, std::vector<std::string_view> names);

  /// Names of the header's cells.
  [[nodiscard]] const std::vector<std::string_view>& columns() const { return columns_; }
  /// The number of the column of that name, compared without case.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
  /// The cells of the next row that is not empty; false at the end. Rows may be shorter or longer than the header.
  bool next(std::vector<std::string_view>& cells);
  /// The number of the line that was given last, from 1.
  [[nodiscard]] std::size_t line() const { return lines_.number(); }
  /// A number in the file's own way of writing; may be NaN or infinite where the file says so.
  [[nodiscard]] std::optional<double> number(std::string_view cell) const;
  /// Whether all cells of the header are numbers: a table without a header.
  [[nodiscard]] bool header_is_row() const;

  [[nodiscard]] base::Error error(std::string what, std::string remedy) const {
    return lines_.error(std::move(what), std::move(remedy));
  }

 private:
  explicit CsvReader(std::string_view text) : lines_(text) {}
  void choose_separator(std::string_view line);
  void split(std::string_view line, std::vector<std::string_view>& cells) const;

  TextLines lines_;
  char separator_ = ',';
  std::vector<std::string_view> columns_;
};

/// The note on a column whose name was there before.
[[nodiscard]] std::string repeats(std::string_view name);

}  // namespace penpose::io
