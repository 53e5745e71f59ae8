#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/text/csv_reader.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/values/bare_values.h"
#include "core/io/tracks/values/value_names.h"
#include "core/io/tracks/values/value_rows.h"
#include "core/io/tracks/values/value_tables.h"
#include "core/rig/control_names.h"

namespace penpose::io {
namespace {

constexpr double k_live_link_fps = 60;

/// What tells when a row was seen, best first. Names without case.
constexpr std::array<const char*, 14> k_clocks{
    "timecode", "time_code", "timestamp",    "timestamp_ms", "time",     "time_s",      "time_ms",
    "seconds",  "frame",     "frame_number", "frame_index",  "frame_id", "frame_count", ""};

/// What is no value of a control.
constexpr std::array<const char*, 10> k_others{"blendshapecount", "_neutral", "neutral", "confidence", "success",
                                               "face_id",         "face",     "subject", "filename",   "file"};

template <std::size_t N>
bool is_one_of(std::string_view name, const std::array<const char*, N>& names) {
  return std::any_of(names.begin(), names.end(), [&](const char* one) { return base::same_but_case(name, one); });
}

std::optional<std::size_t> clock_column(const CsvReader& table) {
  for (const char* name : k_clocks) {
    if (const auto found = table.find(name)) return found;
  }
  return std::nullopt;
}

base::Error too_many_cells(const CsvReader& table, std::size_t cells) {
  return table.error(
      "the row has " + std::to_string(cells) + " cells for " + std::to_string(table.columns().size()) + " columns",
      "write numbers with a decimal point, or separate the cells by semicolons");
}

bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The columns of a table with a row a frame.
struct ValueColumns {
  std::optional<std::size_t> clock;
  std::optional<std::size_t> count;
  std::vector<std::size_t> values;
};

class TableReader {
 public:
  explicit TableReader(CsvReader& table) : table_(table) {
    columns_.clock = clock_column(table);
    columns_.count = table.find("BlendShapeCount");
    std::vector<std::size_t> taken;
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < table.columns().size(); ++i) {
      const std::string_view name = table.columns()[i];
      const bool shape = is_arkit_shape(name);
      if (i == columns_.clock || name.empty() || (!shape && is_one_of(name, k_others))) continue;
      if (!shape && is_one_of(name, k_clocks)) continue;
      taken.push_back(i);
      names.push_back(name);
    }
    const auto plain = plain_names(names);
    std::set<std::string, std::less<>> seen;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      const std::string folded = rig::folded_name(plain[i]);
      if (!seen.insert(folded.empty() ? plain[i] : folded).second) {
        if (rows_.notes.size() < 5) rows_.notes.push_back(repeats(names[i]));
        continue;
      }
      columns_.values.push_back(taken[i]);
      rows_.names.push_back(plain[i]);
    }
  }

  base::Result<animation::WeightTrack> read() {
    if (columns_.values.empty()) {
      return table_.error("there is no column of a blend shape", "export the take again");
    }
    const bool live_link =
        columns_.count || (columns_.clock && base::same_but_case(table_.columns()[*columns_.clock], "timecode"));
    ValueClock when(live_link ? k_live_link_fps : k_common_fps);
    std::vector<std::string_view> cells;
    while (table_.next(cells)) {
      if (rows_.values.size() >= k_most_track_frames) return table_.error("the take has too many frames", "cut it");
      if (rows_.values.size() * columns_.values.size() > k_most_values) {
        return table_.error("the take has over 50,000,000 values", "cut it");
      }
      std::string time;
      if (auto fits = mend(cells, time); !fits) return fits.error();
      when.add(time, table_.number(time));
      if (auto read = read_row(cells); !read) return read.error();
    }
    leave_out_texts();
    return make_value_track(std::move(rows_), when);
  }

 private:
  /// Takes the time out of a row, and puts together what a separator inside of a number or timecode has cut.
  base::Status mend(std::vector<std::string_view>& cells, std::string& time) {
    const std::size_t wide = table_.columns().size();
    const auto clock = columns_.clock;
    if (clock && *clock < cells.size()) time = cells[*clock];
    if (cells.size() <= wide) return base::Done{};
    // 00:00:58;20 between semicolons, and 00:00:58:20,5 between commas.
    const auto colons = std::count(time.begin(), time.end(), ':');
    const bool cut_frames = colons == 2 && cells.size() == wide + 1;
    const bool cut_share = colons == 3 && cells.size() == wide + 1 + columns_.values.size();
    if ((cut_frames || cut_share) && is_digits(cells[*clock + 1])) {
      time.append(cut_frames ? ";" : ".").append(cells[*clock + 1]);
      cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(*clock) + 1);
    }
    if (cells.size() == wide) return base::Done{};
    if (cells.size() != wide + columns_.values.size()) return too_many_cells(table_, cells.size());
    // 0,5 between commas, every number in two: the whole and its decimals.
    std::vector<std::string_view> joined;
    std::size_t at = 0;
    for (std::size_t c = 0; c < wide; ++c) {
      const bool value = std::binary_search(columns_.values.begin(), columns_.values.end(), c);
      const std::string_view whole = cells[at++];
      if (!value) {
        joined.push_back(whole);
        continue;
      }
      const std::string_view decimals = cells[at++];
      const std::string_view unsigned_whole = whole.starts_with('-') ? whole.substr(1) : whole;
      if (!is_digits(unsigned_whole) || !is_digits(decimals)) return too_many_cells(table_, cells.size());
      // They stand side by side in the text, with the comma between them.
      const std::string_view both(whole.data(),
                                  static_cast<std::size_t>(decimals.data() + decimals.size() - whole.data()));
      joined.push_back(both);
    }
    cells = std::move(joined);
    return base::Done{};
  }

  [[nodiscard]] std::optional<double> number(std::string_view cell) const {
    const auto value = table_.number(cell);
    if (value || cell.find(',') == std::string_view::npos) return value;
    std::string pointed(cell);
    std::replace(pointed.begin(), pointed.end(), ',', '.');
    return base::parse_double(pointed);
  }

  base::Status read_row(const std::vector<std::string_view>& cells) {
    rows_.named.push_back("line " + std::to_string(table_.line()));
    std::string& held = rows_.why.emplace_back();
    std::vector<double>& values = rows_.values.emplace_back();
    const auto& count = columns_.count;
    const bool counted = !count || (*count < cells.size() && table_.number(cells[*count]).value_or(0) > 0);
    if (!counted) held = "the tracker found no face";
    if (counted && cells.size() < table_.columns().size()) held = "the row is short";
    texts_.resize(columns_.values.size(), false);
    for (std::size_t i = 0; i < columns_.values.size() && held.empty(); ++i) {
      const std::string_view cell = cells[columns_.values[i]];
      const auto value = number(cell);
      if (is_hole(cell)) {
        rows_.holes.push_back({rows_.values.size() - 1, i});
        values.push_back(0);
        continue;
      }
      if (!value && !texts_[i]) {
        if (rows_.values.size() > 1 || is_arkit_shape(rows_.names[i])) {
          std::string what = "\"";
          what += cell.substr(0, 20);
          what += "\" in column ";
          what += table_.columns()[columns_.values[i]];
          what += " is not a number";
          return table_.error(std::move(what), "write numbers with a decimal point");
        }
        texts_[i] = true;
      }
      if (!texts_[i] && (!value || !(std::abs(*value) < 1e6))) held = "a value is missing or no number";
      values.push_back(texts_[i] ? 0 : value.value_or(0));
    }
    return base::Done{};
  }

  /// Columns of names and the like drive nothing.
  void leave_out_texts() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < rows_.names.size(); ++i) {
      if (i < texts_.size() && texts_[i]) {
        rows_.notes.push_back("the column " + rows_.names[i].substr(0, 40) + " holds no numbers and is left out");
      } else {
        names.push_back(rows_.names[i]);
      }
    }
    if (names.size() == rows_.names.size()) return;
    std::vector<std::size_t> place(texts_.size(), 0);
    for (std::size_t i = 1; i < texts_.size(); ++i) place[i] = place[i - 1] + (texts_[i - 1] ? 0 : 1);
    std::vector<ValueRows::Hole> holes;
    for (const ValueRows::Hole& hole : rows_.holes) {
      if (!texts_[hole.name]) holes.push_back({hole.row, place[hole.name]});
    }
    rows_.holes = std::move(holes);
    for (auto& values : rows_.values) {
      std::vector<double> kept;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!texts_[i]) kept.push_back(values[i]);
      }
      values = std::move(kept);
    }
    rows_.names = std::move(names);
  }

  CsvReader& table_;
  ValueColumns columns_;
  ValueRows rows_;
  std::vector<bool> texts_;  ///< one a name: its first row holds no number
};

/// The columns of a table with a row a value.
struct LongValues {
  std::optional<std::size_t> name;
  std::optional<std::size_t> value;
  std::optional<std::size_t> clock;
};

LongValues long_columns(const CsvReader& table) {
  LongValues columns;
  for (const char* name : {"categoryname", "category_name", "blendshape", "blendshape_name", "shape", "name"}) {
    if (!columns.name) columns.name = table.find(name);
  }
  for (const char* name : {"score", "value", "weight"}) {
    if (!columns.value) columns.value = table.find(name);
  }
  columns.clock = clock_column(table);
  return columns;
}

base::Result<animation::WeightTrack> read_long(CsvReader& table, const LongValues& columns) {
  ValueRows rows;
  ValueClock when(k_common_fps);
  std::map<std::string, std::size_t, std::less<>> index;
  std::string before;
  std::vector<std::string_view> cells;
  while (table.next(cells)) {
    if (cells.size() > table.columns().size()) return too_many_cells(table, cells.size());
    if (cells.size() <= std::max({*columns.name, *columns.value, *columns.clock})) continue;
    const auto value = table.number(cells[*columns.value]);
    if (!value || !(std::abs(*value) < 1e6)) continue;
    if (rows.values.empty() || cells[*columns.clock] != before) {
      if (rows.values.size() >= k_most_track_frames) return table.error("the take has too many frames", "cut it");
      before = cells[*columns.clock];
      when.add(before, table.number(before));
      rows.named.push_back("line " + std::to_string(table.line()));
      rows.why.emplace_back();
      rows.values.emplace_back();
    }
    const std::string_view name = cells[*columns.name];
    if (is_one_of(name, k_others)) continue;
    const auto [at, is_new] = index.try_emplace(std::string(name), rows.names.size());
    if (is_new) rows.names.emplace_back(name);
    if ((rows.values.size() + 1) * rows.names.size() > k_most_values) {
      return table.error("the take has over 50,000,000 values", "cut it");
    }
    if (at->second >= rows.values.back().size()) rows.values.back().resize(at->second + 1);
    rows.values.back()[at->second] = *value;
  }
  for (auto& values : rows.values) values.resize(rows.names.size());
  rows.names = plain_names({rows.names.begin(), rows.names.end()});
  return make_value_track(std::move(rows), when);
}

/// A table without a header.
base::Result<animation::WeightTrack> read_bare_table(base::Bytes bytes, const BareTable& bare) {
  const auto names = usual_names(bare.count);
  std::vector<std::string_view> columns(names.begin(), names.end());
  if (bare.timed) columns.insert(columns.begin(), "time");
  auto table = CsvReader::open_bare(base::as_text(bytes), std::move(columns));
  if (!table) return table.error();
  auto track = TableReader(*table).read();
  if (track) track->notes.insert(track->notes.begin(), usual_names_note(bare.count));
  return track;
}

bool is_long(const LongValues& columns) { return columns.name && columns.value && columns.clock; }

}  // namespace

bool has_value_columns(const CsvReader& table) {
  if (table.find("Timecode")) return true;
  if (table.header_is_row()) return false;
  const std::vector<std::string_view>& names = table.columns();
  const auto plain = plain_names(names);
  const auto shapes = static_cast<std::size_t>(std::count_if(plain.begin(), plain.end(), is_arkit_shape));
  constexpr std::size_t k_sure = 3;
  if (shapes >= k_sure || (shapes > 0 && 2 * shapes >= names.size())) return true;
  return is_long(long_columns(table)) &&
         (table.find("categoryname") || table.find("category_name") || table.find("blendshape"));
}

base::Result<animation::WeightTrack> read_value_table(base::Bytes bytes) {
  if (const BareTable bare = bare_table(base::as_text(bytes)); bare.count > 0) return read_bare_table(bytes, bare);
  auto table = CsvReader::open(base::as_text(bytes));
  if (!table) return table.error();
  const auto columns = long_columns(*table);
  if (is_long(columns)) return read_long(*table, columns);
  if (!has_value_columns(*table)) {
    return table->error("there is no column Timecode and none of a blend shape of ARKit",
                        "export the take as Live Link Face CSV");
  }
  return TableReader(*table).read();
}

}  // namespace penpose::io
