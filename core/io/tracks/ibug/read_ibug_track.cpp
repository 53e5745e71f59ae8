#include <algorithm>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/tracks/best_face.h"
#include "core/io/tracks/face_points.h"
#include "core/io/tracks/point_table.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "core/io/tracks/values/bare_values.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_numbers = 2 * k_ibug_points;

void finish_row(TrackRow& row) {
  if (row.why_held.empty() && row.points.size() != k_ibug_points) {
    row.why_held = "the frame has " + std::to_string(row.points.size()) + " of 68 points";
  }
  if (!row.why_held.empty()) {
    row.points.clear();
  } else {
    row.depths = common_depths(row.points);
  }
}

/// Blocks "version: 1 / n_points: 68 / { / x y / ... / }".
base::Result<std::vector<TrackRow>> read_blocks(std::string_view text) {
  TextLines lines(text);
  std::vector<TrackRow> rows;
  bool inside = false;
  TrackRow row;
  while (const auto line = lines.next()) {
    std::string_view content = base::trim(*line);
    if (content.empty() || content.starts_with("version") || content.starts_with("//")) continue;
    if (content.starts_with("n_points")) {
      const auto colon = content.find(':');
      const auto n =
          colon == std::string_view::npos ? std::nullopt : base::parse_int(base::trim(content.substr(colon + 1)));
      if (!n || *n != static_cast<std::int64_t>(k_ibug_points))
        return lines.error("files of 68 points are read, this one has another number",
                           "track with the 68-point markup");
      continue;
    }
    if (content == "{") {
      if (inside) return lines.error("a block opens within a block", "the file is damaged");
      inside = true;
      row = {};
      row.line = lines.number();
      continue;
    }
    if (content == "}") {
      if (!inside) return lines.error("a block ends that did not open", "the file is damaged");
      inside = false;
      finish_row(row);
      if (rows.size() >= k_most_track_frames)
        return lines.error("a track has at most 1,000,000 frames", "cut the video");
      rows.push_back(std::move(row));
      continue;
    }
    if (!inside) return lines.error("\"{\" was expected", "give a .pts file or a CSV file of 68 points");
    const auto x = base::parse_double(take_word(content));
    const auto y = base::parse_double(take_word(content));
    if (!x || !y || !base::trim(content).empty())
      return lines.error("two numbers x y were expected", "write numbers with a decimal point");
    if (!usable_coordinate(*x) || !usable_coordinate(*y)) row.why_held = "a coordinate is no number";
    if (row.points.size() >= k_ibug_points)
      return lines.error("the block has more than 68 points", "the file is damaged");
    row.points.push_back({*x, *y});
  }
  if (inside) {
    row.why_held = "the block does not end";
    finish_row(row);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Rows of 136 numbers and no header.
base::Result<std::vector<TrackRow>> read_bare_rows(const CsvReader& header, CsvReader& table) {
  std::vector<TrackRow> rows;
  std::vector<std::string_view> cells = header.columns();
  do {
    TrackRow row;
    row.line = rows.empty() ? header.line() : table.line();
    if (cells.size() > k_numbers)
      return table.error("the row has more than 136 numbers", "write numbers with a decimal point");
    for (std::size_t i = 0; i + 1 < cells.size(); i += 2) {
      const auto x = table.number(cells[i]);
      const auto y = table.number(cells[i + 1]);
      if ((!x && !cells[i].empty()) || (!y && !cells[i + 1].empty()))
        return table.error("a number was expected", "write numbers with a decimal point");
      if (!x || !y || !usable_coordinate(*x) || !usable_coordinate(*y)) {
        row.why_held = "a coordinate is missing or no number";
        break;
      }
      row.points.push_back({*x, *y});
    }
    finish_row(row);
    if (rows.size() >= k_most_track_frames) return table.error("a track has at most 1,000,000 frames", "cut the video");
    rows.push_back(std::move(row));
  } while (table.next(cells));
  return rows;
}

base::Result<std::vector<TrackRow>> read_table(CsvReader& table, std::vector<std::string>& notes) {
  const auto columns = find_point_columns(table, k_ibug_points, [](std::size_t i, int axis) {
    std::string under(1, "xyz"[axis]);
    std::string plain = under;
    under += "_";
    under += std::to_string(i);
    plain += std::to_string(i);
    return std::vector<std::string>{under, plain};
  });
  if (!columns) return columns.error();
  notes = columns->notes;
  auto rows = read_point_rows(table, *columns, [](const auto&, TrackRow& row) { finish_row(row); });
  if (!rows) return rows.error();
  return rows_of_best_face(std::move(rows).value(), notes);
}

}  // namespace

base::Result<animation::PointTrack> read_ibug_track(base::Bytes bytes) {
  std::string_view text = base::as_text(bytes);
  text = base::without_mark(text);
  std::vector<std::string> notes;
  base::Result<std::vector<TrackRow>> rows = base::Error{};
  if (text.find('{') != std::string_view::npos) {
    rows = read_blocks(text);
  } else {
    auto table = CsvReader::open(text);
    if (!table) return table.error();
    const CsvReader header = *table;
    rows = table->header_is_row() ? read_bare_rows(header, *table) : read_table(*table, notes);
  }
  if (!rows) return rows.error();
  take_small_units(*rows);
  return noted(make_track(std::move(rows).value(), k_ibug_points, k_common_fps), notes);
}

TrackFormat ibug68_format() {
  return {"ibug68", 3, false,
          [](const TrackText& text) {
            if (text.json) return false;
            if (text.text.find("n_points") != std::string_view::npos) return true;
            // More points than 68, and not as many as a face mesh, are no face that is known.
            if (text.has("x_68") || text.has("x68")) return false;
            if (text.has("x_0") || text.has("x0")) return true;
            // A number alone begins captions, and as many as a face has shapes are values.
            constexpr std::size_t k_fewest = 3;
            return text.table && text.table->columns().size() >= k_fewest && text.table->header_is_row() &&
                   bare_table(text.text).count == 0;
          },
          [](base::Bytes bytes, std::optional<PictureSize>) { return as_track(read_ibug_track(bytes)); }};
}

}  // namespace penpose::io
