#include <algorithm>

#include "core/model_io/face_points.h"
#include "core/model_io/point_table.h"
#include "core/model_io/read_track.h"

namespace penpose::model_io {

base::Result<animation::PointTrack> read_openface_track(base::Bytes bytes) {
  auto table = CsvReader::open(base::as_text(bytes));
  if (!table) return table.error();
  const auto columns = find_point_columns(*table, k_ibug_points, [](std::size_t i, int axis) {
    constexpr std::array<const char*, 3> k_axes{"x_", "y_", "no column of depths "};
    return std::vector<std::string>{k_axes[static_cast<std::size_t>(axis)] + std::to_string(i)};
  });
  if (!columns) return columns.error();
  std::vector<FaceRow> rows;
  std::vector<std::string_view> cells;
  while (table->next(cells)) {
    auto row = read_point_row(*table, *columns, cells);
    if (!row) return row.error();
    if (row->row.why_held.empty()) row->row.depths = common_depths(row->row.points);
    if (rows.size() >= 4 * k_most_track_frames) return table->error("the table has too many rows", "cut the video");
    rows.push_back(std::move(row).value());
  }
  std::vector<std::string> notes;
  auto best = rows_of_best_face(std::move(rows), notes);
  auto track = make_track(std::move(best), k_ibug_points, k_common_fps);
  if (!track) return track;
  track->notes.insert(track->notes.begin(), notes.begin(), notes.end());
  return track;
}

}  // namespace penpose::model_io
