#include "core/io/tracks/point_table.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/text/letters.h"
#include "core/io/tracks/read_track.h"

namespace penpose::io {
namespace {

/// Columns by name, as it is and without case; the first of a name counts.
struct ColumnIndex {
  std::map<std::string, std::size_t, std::less<>> exact;
  std::map<std::string, std::size_t, std::less<>> folded;
};

/// Whether capitals count. OpenFace has x_0 in px and X_0 in mm in one file: where the one is missing, the other is
/// none.
enum class Capitals : std::uint8_t { count, as_you_like };

std::optional<std::size_t> column_of(const ColumnIndex& index, const std::vector<std::string>& names,
                                     Capitals capitals = Capitals::as_you_like) {
  for (const std::string& name : names) {
    if (const auto found = index.exact.find(name); found != index.exact.end()) return found->second;
  }
  if (capitals == Capitals::count) return std::nullopt;
  for (const std::string& name : names) {
    if (const auto found = index.folded.find(base::lower_case(name)); found != index.folded.end()) return found->second;
  }
  return std::nullopt;
}

}  // namespace

bool usable_coordinate(double value) { return std::abs(value) < 1e7; }

base::Result<PointColumns> find_point_columns(const CsvReader& table, std::size_t count, const ColumnNames& names) {
  ColumnIndex index;
  PointColumns columns;
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const std::string_view name = table.columns()[i];
    constexpr std::size_t k_most_notes = 5;
    if (!index.exact.emplace(name, i).second && !name.empty() && columns.notes.size() < k_most_notes) {
      columns.notes.push_back(repeats(name));
    }
    index.folded.emplace(base::lower_case(name), i);
  }
  const Capitals capitals = index.exact.contains("success") ? Capitals::count : Capitals::as_you_like;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::size_t, 3> place{PointColumns::k_none, PointColumns::k_none, PointColumns::k_none};
    for (int axis = 0; axis < 3; ++axis) {
      const auto wanted = names(i, axis);
      const auto found = column_of(index, wanted, capitals);
      if (found) place[static_cast<std::size_t>(axis)] = *found;
      if (found || axis == 2) continue;
      return table.error("the column " + wanted.front() + " is missing",
                         "export the track with all " + std::to_string(count) + " points");
    }
    columns.points.push_back(place);
  }
  columns.frame = column_of(index, {"frame"});
  columns.time = column_of(index, {"timestamp", "time", "time_s"});
  columns.confidence = column_of(index, {"confidence"});
  columns.success = column_of(index, {"success"});
  columns.face = column_of(index, {"face_id"});
  return columns;
}

base::Result<FaceRow> read_point_row(const CsvReader& table, const PointColumns& columns,
                                     const std::vector<std::string_view>& cells) {
  FaceRow result;
  TrackRow& row = result.row;
  row.line = table.line();
  if (cells.size() > table.columns().size()) {
    return table.error("the row has " + std::to_string(cells.size()) + " cells for " +
                           std::to_string(table.columns().size()) + " columns",
                       "write numbers with a decimal point, or separate the cells by semicolons");
  }
  std::optional<base::Error> problem;
  const auto number_at = [&](std::size_t column) -> std::optional<double> {
    if (column >= cells.size()) return std::nullopt;
    if (cells[column].empty()) return std::nullopt;
    const auto value = table.number(cells[column]);
    if (!value && !problem) {
      std::string what(cells[column].substr(0, 20));
      what += " in column ";
      what += table.columns()[column];
      what += " is not a number";
      problem = table.error(std::move(what), "write numbers with a decimal point");
    }
    return value;
  };
  const auto whole_at = [&](std::optional<std::size_t> column) -> std::optional<std::int64_t> {
    const auto value = column ? number_at(*column) : std::nullopt;
    if (!value || !(std::abs(*value) < 1e15)) return std::nullopt;
    return static_cast<std::int64_t>(*value);
  };
  constexpr double k_latest = 1e19;  // nanoseconds since 1970 have 19 digits
  row.frame = whole_at(columns.frame);
  result.face = whole_at(columns.face).value_or(0);
  if (columns.time) row.time_s = number_at(*columns.time);
  if (row.time_s && !(std::abs(*row.time_s) < k_latest)) row.time_s.reset();
  if (columns.confidence) row.confidence = number_at(*columns.confidence).value_or(0);
  const double success = columns.success ? number_at(*columns.success).value_or(0) : 1;
  if (cells.size() < table.columns().size()) {
    row.why_held = "the row has " + std::to_string(cells.size()) + " cells for " +
                   std::to_string(table.columns().size()) + " columns";
  } else if (!(success > 0)) {
    row.why_held = "the tracker found no face";
  } else if (!(row.confidence > 0)) {
    row.why_held = "the tracker's confidence is 0";
  }
  bool depths = true;
  for (const auto& place : columns.points) {
    const double nothing = std::nan("");
    const double x = number_at(place[0]).value_or(nothing);
    const double y = number_at(place[1]).value_or(nothing);
    const double z = place[2] == PointColumns::k_none ? nothing : number_at(place[2]).value_or(nothing);
    if (!row.why_held.empty()) continue;
    if (!usable_coordinate(x) || !usable_coordinate(y)) {
      row.why_held = "a coordinate is missing or no number";
      continue;
    }
    row.points.push_back({x, y});
    row.depths.push_back(-z);
    depths = depths && usable_coordinate(z);
  }
  if (problem) return *problem;
  if (!row.why_held.empty()) row.points.clear();
  if (!row.why_held.empty() || !depths) row.depths.clear();
  return result;
}

base::Result<std::vector<FaceRow>> read_point_rows(CsvReader& table, const PointColumns& columns,
                                                   const RowFinish& finish) {
  std::vector<FaceRow> rows;
  std::vector<std::string_view> cells;
  while (table.next(cells)) {
    auto row = read_point_row(table, columns, cells);
    if (!row) return row.error();
    if (finish) finish(cells, row->row);
    if (rows.size() >= 4 * k_most_track_frames) return table.error("the table has too many rows", "cut the video");
    rows.push_back(std::move(row).value());
  }
  return rows;
}

}  // namespace penpose::io
