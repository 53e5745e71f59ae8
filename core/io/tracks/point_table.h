#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/io/text/csv_reader.h"
#include "core/io/tracks/track_rows.h"

namespace penpose::io {

/// Where a table of a row a frame keeps its numbers.
struct PointColumns {
  static constexpr std::size_t k_none = static_cast<std::size_t>(-1);
  std::vector<std::array<std::size_t, 3>> points;  ///< columns of x, y and z (k_none: no z), one a point
  std::optional<std::size_t> frame, time, confidence, success, face;
  std::vector<std::string> notes;  ///< on columns of a name that another has
};

/// Names of a coordinate's column that may stand for point i, axis 0..2.
using ColumnNames = std::function<std::vector<std::string>(std::size_t point, int axis)>;

/// Finds the columns of `count` points. Errors (place "line N"): the first column that is missing.
[[nodiscard]] base::Result<PointColumns> find_point_columns(const CsvReader& table, std::size_t count,
                                                            const ColumnNames& names);

/// A row of the table and the number of the face that it is of (0 where the table has no such column).
struct FaceRow {
  std::int64_t face = 0;
  TrackRow row;
};

/// Reads one row. Rows that are short, show no success or confidence, or hold NaN are held and say why. Errors (place
/// "line N"): more cells than columns, text where a number was expected.
[[nodiscard]] base::Result<FaceRow> read_point_row(const CsvReader& table, const PointColumns& columns,
                                                   const std::vector<std::string_view>& cells);

/// What else a format reads of a row, from its cells.
using RowFinish = std::function<void(const std::vector<std::string_view>& cells, TrackRow& row)>;
/// Reads all rows that are left of the table. Errors: those of a row, and more rows than four faces in
/// k_most_track_frames have.
[[nodiscard]] base::Result<std::vector<FaceRow>> read_point_rows(CsvReader& table, const PointColumns& columns,
                                                                 const RowFinish& finish = {});

/// A coordinate that distances can be taken of: finite and below 1e7.
[[nodiscard]] bool usable_coordinate(double value);

}  // namespace penpose::io
