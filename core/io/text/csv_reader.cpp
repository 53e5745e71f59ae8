#include "core/io/text/csv_reader.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"

namespace penpose::io {
namespace {

std::string_view bare(std::string_view cell) {
  cell = base::trim(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = base::trim(cell.substr(1, cell.size() - 2));
  return cell;
}

}  // namespace

std::string repeats(std::string_view name) {
  return "line 1: the column " + std::string(name.substr(0, 40)) + " comes again; the first one counts";
}

base::Result<CsvReader> CsvReader::open(std::string_view text) {
  CsvReader reader(base::without_mark(text));
  while (const auto line = reader.lines_.next()) {
    if (base::trim(*line).empty()) continue;
    reader.choose_separator(*line);
    reader.split(*line, reader.columns_);
    return reader;
  }
  return base::Error{"the table is empty", "line 1", "a header line and rows of numbers were expected"};
}

base::Result<CsvReader> CsvReader::open_bare(std::string_view text, std::vector<std::string_view> names) {
  CsvReader reader(base::without_mark(text));
  TextLines lines = reader.lines_;
  while (const auto line = lines.next()) {
    const std::string_view row = base::trim(*line);
    if (row.empty()) continue;
    reader.choose_separator(row);
    if (row.find(reader.separator_) == std::string_view::npos) reader.separator_ = ' ';
    reader.columns_ = std::move(names);
    return reader;
  }
  return base::Error{"the table is empty", "line 1", "rows of numbers were expected"};
}

void CsvReader::choose_separator(std::string_view line) {
  const auto count = [&](char c) { return std::count(line.begin(), line.end(), c); };
  if (count(';') > count(separator_)) separator_ = ';';
  if (count('\t') > count(separator_)) separator_ = '\t';
}

void CsvReader::split(std::string_view line, std::vector<std::string_view>& cells) const {
  cells.clear();
  while (true) {
    const std::size_t end = std::min(line.find(separator_), line.size());
    // Blanks that stand side by side are one.
    if (separator_ != ' ' || end > 0) cells.push_back(bare(line.substr(0, end)));
    if (end == line.size()) break;
    line.remove_prefix(end + 1);
  }
  // A separator at the end of each line is a habit of some programs; else the last cell is empty.
  const bool habit = columns_.empty() || cells.size() > columns_.size();
  if (habit && cells.size() > 1 && cells.back().empty()) cells.pop_back();
}

std::optional<std::size_t> CsvReader::find(std::string_view name) const {
  const auto found = std::find_if(columns_.begin(), columns_.end(),
                                  [&](std::string_view column) { return base::same_but_case(column, name); });
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

bool CsvReader::next(std::vector<std::string_view>& cells) {
  while (const auto line = lines_.next()) {
    if (base::trim(*line).empty()) continue;
    split(*line, cells);
    return true;
  }
  return false;
}

std::optional<double> CsvReader::number(std::string_view cell) const {
  if (separator_ == ',' || cell.find(',') == std::string_view::npos) return base::parse_double(cell);
  std::string with_point(cell);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  return base::parse_double(with_point);
}

bool CsvReader::header_is_row() const {
  return std::all_of(columns_.begin(), columns_.end(), [&](std::string_view cell) { return number(cell).has_value(); });
}

}  // namespace penpose::io
