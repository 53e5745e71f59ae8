#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/text/letters.h"
#include "core/io/tracks/best_face.h"
#include "core/io/tracks/cues/cue_file.h"
#include "core/io/tracks/face_points.h"
#include "core/io/tracks/picture_scale.h"
#include "core/io/tracks/point_table.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "core/io/tracks/values/value_tables.h"

namespace penpose::io {
namespace {

std::vector<std::string> column_names_of(std::size_t point, int axis) {
  const std::string letter(1, "xyz"[axis]);
  const std::string number = std::to_string(point);
  std::string under = letter;
  under += "_";
  under += number;
  std::string plain = letter;
  plain += number;
  std::string long_name = "landmark_";
  long_name += number;
  long_name += "_";
  long_name += letter;
  std::string turned = number;
  turned += "_";
  turned += letter;
  return {under, plain, long_name, turned};
}

base::Result<std::vector<TrackRow>> read_wide(CsvReader& table, std::size_t& count, std::vector<std::string>& notes) {
  auto columns = find_point_columns(table, k_mediapipe_iris_points, column_names_of);
  count = k_mediapipe_iris_points;
  if (!columns) {
    columns = find_point_columns(table, k_mediapipe_points, column_names_of);
    count = k_mediapipe_points;
  }
  if (!columns) return columns.error();
  notes = columns->notes;
  auto rows = read_point_rows(table, *columns);
  if (!rows) return rows.error();
  return rows_of_best_face(std::move(rows).value(), notes);
}

/// A row a point.
struct LongColumns {
  std::size_t frame, point, x, y;
  std::optional<std::size_t> z, time;
};

std::optional<LongColumns> find_long(const CsvReader& table) {
  const auto any = [&](std::initializer_list<const char*> names) -> std::optional<std::size_t> {
    for (const char* name : names) {
      if (const auto found = table.find(name)) return found;
    }
    return std::nullopt;
  };
  const auto frame = any({"frame", "frame_id", "frame_index"});
  const auto point = any({"landmark", "landmark_id", "landmark_index", "index", "id", "point"});
  const auto x = any({"x"});
  const auto y = any({"y"});
  if (!frame || !point || !x || !y) return std::nullopt;
  return LongColumns{*frame, *point, *x, *y, any({"z"}), any({"timestamp", "time", "time_s"})};
}

base::Result<std::vector<TrackRow>> read_long(CsvReader& table, const LongColumns& columns, std::size_t& count,
                                              std::vector<std::string>& notes) {
  struct Frame {
    TrackRow row;
    std::vector<bool> seen;
  };
  std::map<std::int64_t, Frame> frames;
  std::size_t highest = 0;
  FrameNotes again;
  std::vector<std::string_view> cells;
  while (table.next(cells)) {
    const auto number_at = [&](std::optional<std::size_t> column) -> std::optional<double> {
      return column && *column < cells.size() ? table.number(cells[*column]) : std::nullopt;
    };
    const auto frame = number_at(columns.frame);
    const auto point = number_at(columns.point);
    if (cells.size() > table.columns().size()) {
      return table.error("the row has more cells than columns", "write numbers with a decimal point");
    }
    if (!frame || !(std::abs(*frame) < 1e15) || !point || !(*point >= 0 && *point < k_mediapipe_iris_points)) {
      return table.error("a frame number and a landmark number of 0 to 477 were expected", "export the track again");
    }
    auto& entry = frames[static_cast<std::int64_t>(*frame)];
    if (frames.size() > k_most_track_frames) return table.error("the table has too many frames", "cut the video");
    if (entry.seen.empty()) {
      entry.row.line = table.line();
      entry.row.frame = static_cast<std::int64_t>(*frame);
      entry.row.points.resize(k_mediapipe_iris_points);
      entry.row.depths.resize(k_mediapipe_iris_points, std::nan(""));
      entry.seen.resize(k_mediapipe_iris_points);
      entry.row.time_s = number_at(columns.time);
    }
    const auto i = static_cast<std::size_t>(*point);
    const double x = number_at(columns.x).value_or(std::nan(""));
    const double y = number_at(columns.y).value_or(std::nan(""));
    if (!usable_coordinate(x) || !usable_coordinate(y)) continue;
    if (entry.seen[i]) {
      again.add("line " + std::to_string(table.line()) + ": landmark " + std::to_string(i) + " of frame " +
                std::to_string(*entry.row.frame) + " comes again; the first one counts");
      continue;
    }
    entry.row.points[i] = {x, y};
    entry.row.depths[i] = -number_at(columns.z).value_or(std::nan(""));
    entry.seen[i] = true;
    highest = std::max(highest, i);
  }
  count = highest < k_mediapipe_points ? k_mediapipe_points : k_mediapipe_iris_points;
  std::vector<TrackRow> rows;
  for (auto& [number, frame] : frames) {
    const auto missing = std::find(frame.seen.begin(), frame.seen.begin() + static_cast<std::ptrdiff_t>(count), false);
    const auto at = static_cast<std::size_t>(missing - frame.seen.begin());
    if (at < count) frame.row.why_held = "landmark " + std::to_string(at) + " is missing or no number";
    frame.row.points.resize(at < count ? 0 : count);
    frame.row.depths.resize(at < count ? 0 : count);
    if (!std::all_of(frame.row.depths.begin(), frame.row.depths.end(), usable_coordinate)) frame.row.depths.clear();
    rows.push_back(std::move(frame.row));
  }
  notes = again.take();
  return rows;
}

/// Whether JSON that holds no curves and no scores is of this format: a list, or what names points or frames.
bool may_hold_points(const TrackText& text) {
  const std::string_view bare = base::without_mark(text.text);
  const auto first = bare.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bare[first] == '[') return true;
  for (const char* word : {"andmark", "\"frames\"", "\"points\"", "\"keypoints\"", "\"faces\""}) {
    if (text.mentions(word)) return true;
  }
  return false;
}

}  // namespace

base::Result<animation::PointTrack> read_mediapipe_csv(base::Bytes bytes, std::optional<PictureSize> picture) {
  auto table = CsvReader::open(base::as_text(bytes));
  if (!table) return table.error();
  std::size_t count = 0;
  std::vector<std::string> notes;
  const auto long_columns = find_long(*table);
  auto rows = long_columns ? read_long(*table, *long_columns, count, notes) : read_wide(*table, count, notes);
  if (!rows) return rows.error();
  take_small_units(*rows);
  scale_to_picture(*rows, picture, notes);
  return noted(make_track(std::move(rows).value(), count, k_common_fps), notes);
}

TrackFormat mediapipe_format() {
  return {"mediapipe", 2, false,
          [](const TrackText& text) {
            if (text.json) {
              const bool other = mentions_values(text.text) || has_vmc(text.text) || looks_like_cues(text.text);
              return !text.mentions("\"curves\"") && !other && may_hold_points(text);
            }
            for (const auto* column :
                 {"landmark", "landmark_id", "landmark_index", "x_467", "x467", "landmark_467_x", "467_x"}) {
              if (text.has(column)) return true;
            }
            return text.has("x") && text.has("frame");
          },
          [](base::Bytes bytes, std::optional<PictureSize> picture) {
            const TrackText text(bytes);
            if (!text.json) {
              auto points = read_mediapipe_csv(bytes, picture);
              if (!points && text.table && has_value_columns(*text.table)) return as_track(read_value_table(bytes));
              return as_track(std::move(points));
            }
            auto points = read_mediapipe_json(bytes, picture);
            if (!points && mentions_values(text.text)) return as_track(read_value_json(bytes));
            return as_track(std::move(points));
          }};
}

}  // namespace penpose::io
