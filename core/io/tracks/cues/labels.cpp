#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/text/csv_reader.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/cues/internal/cue_reader.h"

namespace penpose::io {
namespace {

/// A number with a decimal point or comma.
std::optional<double> label_time(std::string_view text) {
  std::string pointed(base::trim(text));
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  return base::parse_double(pointed);
}

std::string_view first_line(std::string_view text) {
  const auto start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return {};
  text.remove_prefix(start);
  return text.substr(0, std::min(text.find_first_of("\r\n"), text.size()));
}

/// "start<tab>end<tab>label".
bool begins_with_label(std::string_view text) {
  const std::string_view line = first_line(text);
  const std::size_t first = line.find('\t');
  const std::size_t second = first == std::string_view::npos ? first : line.find('\t', first + 1);
  if (first == std::string_view::npos || !label_time(line.substr(0, first))) return false;
  const std::string_view end = line.substr(first + 1, second == std::string_view::npos ? second : second - first - 1);
  if (!label_time(end)) return false;
  // A table of numbers has more of them.
  return second == std::string_view::npos || !label_time(line.substr(second + 1)) ||
         line.find('\t', second + 1) == std::string_view::npos;
}

CueProblem read_label_lines(std::string_view text, CueBuilder& cues) {
  TextLines lines(text);
  while (const auto line = lines.next()) {
    // A line that begins with a backslash has the frequencies of the label before.
    if (base::trim(*line).empty() || line->starts_with('\\')) continue;
    const std::string place = "line " + std::to_string(lines.number());
    const std::size_t first = line->find('\t');
    if (first == std::string_view::npos) return cues.wrong("a start, an end and a label were expected", place);
    const std::size_t second = std::min(line->find('\t', first + 1), line->size());
    const auto from = label_time(line->substr(0, first));
    const auto to = label_time(line->substr(first + 1, second - first - 1));
    if (!from || !to) return cues.wrong("a start, an end and a label were expected", place);
    if (auto problem = cues.label(from, to, line->substr(std::min(second + 1, line->size())), place)) return problem;
  }
  return std::nullopt;
}

/// The columns of a table of labels.
struct LabelColumns {
  std::optional<std::size_t> from, to, text, type;
};

std::optional<LabelColumns> label_columns(const CsvReader& table) {
  LabelColumns columns;
  const auto find = [&](std::optional<std::size_t>& column, std::initializer_list<const char*> names) {
    for (const char* name : names) {
      if (!column) column = table.find(name);
    }
  };
  find(columns.from, {"start", "begin", "start_time", "xmin", "tmin", "onset"});
  find(columns.to, {"end", "stop", "end_time", "xmax", "tmax", "offset"});
  find(columns.text, {"word", "label", "text", "phone", "phoneme", "viseme"});
  find(columns.type, {"type", "tier"});
  if (!columns.from || !columns.to || !columns.text) return std::nullopt;
  return columns;
}

/// A table with names of its columns: Whisper's .tsv, whose times are whole milliseconds, and the .csv of the Montreal
/// Forced Aligner, which says of each row what it is.
CueProblem read_label_table(std::string_view text, CueBuilder& cues) {
  auto table = CsvReader::open(text);
  if (!table) return table.error();
  const auto columns = label_columns(*table);
  if (!columns) return cues.wrong("columns start, end and text were expected", "line 1");
  struct Row {
    double from = 0, to = 0;
    std::string text, type, place;
  };
  std::vector<Row> rows;
  std::vector<std::string_view> cells;
  bool whole = true;
  double last = 0;
  while (table->next(cells)) {
    const std::string place = "line " + std::to_string(table->line());
    if (cells.size() <= std::max({*columns->from, *columns->to, *columns->text})) continue;
    const auto from = table->number(cells[*columns->from]), to = table->number(cells[*columns->to]);
    if (!from || !to) return cues.wrong("a start and an end were expected", place);
    if (rows.size() >= 300'000) return cues.wrong("a list of cues has at most 300,000 labels", place);
    whole = whole && *from == std::floor(*from) && *to == std::floor(*to);
    last = std::max(last, *to);
    const bool typed = columns->type && *columns->type < cells.size();
    rows.push_back({*from, *to, std::string(cells[*columns->text]),
                    base::lower_case(typed ? cells[*columns->type] : std::string_view()), place});
  }
  const double unit = whole && last >= 20.0 * static_cast<double>(rows.size()) && last >= 100 ? 1000 : 1;
  for (const Row& row : rows) {
    const double from = row.from / unit, to = row.to / unit;
    const CueProblem problem = row.type.starts_with("phone")  ? cues.phone(from, to, row.text, row.place)
                               : row.type.starts_with("word") ? cues.word(from, to, row.text, row.place)
                                                              : cues.label(from, to, row.text, row.place);
    if (problem) return problem;
  }
  return std::nullopt;
}

bool has_label_header(std::string_view text) {
  const auto table = CsvReader::open(text.substr(0, 4096));
  return table && label_columns(*table).has_value();
}

}  // namespace

CueReader labels_reader() {
  return {
      "Audacity's labels", "export the labels again from Audacity",
      [](std::string_view text) { return begins_with_label(text) || (!begins_json(text) && has_label_header(text)); },
      [](std::string_view text, CueBuilder& cues) {
        return begins_with_label(text) ? read_label_lines(text, cues) : read_label_table(text, cues);
      }};
}

}  // namespace penpose::io
