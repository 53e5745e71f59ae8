#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/base/math.h"
#include "core/geometry/rotation.h"
#include "core/io/tracks/best_face.h"
#include "core/io/tracks/face_points.h"
#include "core/io/tracks/openface/openface_units.h"
#include "core/io/tracks/point_table.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"

namespace penpose::io {

namespace {

/// The numbers of columns by their names; false where one is missing.
template <std::size_t count, typename NameOf>
bool find_columns(const CsvReader& table, std::array<std::size_t, count>& columns, const NameOf& name_of) {
  const auto names = table.columns();
  for (std::size_t i = 0; i < count; ++i) {
    const auto found = std::find(names.begin(), names.end(), name_of(i));
    if (found == names.end()) return false;
    columns[i] = static_cast<std::size_t>(found - names.begin());
  }
  return true;
}

/// The columns X_i, Y_i, Z_i: where the tracker's own model of the face has the points, mm, z away from the camera.
/// Files without them are common.
class SolidFace {
 public:
  explicit SolidFace(const CsvReader& table) {
    there_ = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      there_ = there_ && find_columns(table, columns_[axis], [axis](std::size_t i) {
                 return std::string(1, "XYZ"[axis]) + "_" + std::to_string(i);
               });
    }
  }

  /// As common_depths, from the row itself. Empty where it has no face that could be one.
  [[nodiscard]] std::vector<double> depths(const CsvReader& table, const std::vector<std::string_view>& cells,
                                           std::span<const animation::PxPoint> points) const {
    std::vector<double> depths;
    if (!there_) return depths;
    const auto at = [&](std::size_t axis, std::size_t i) {
      const std::size_t column = columns_[axis][i];
      return column < cells.size() ? table.number(cells[column]).value_or(std::nan("")) : std::nan("");
    };
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double apart = at(axis, k_eye_right) - at(axis, k_eye_left);
      square += apart * apart;
    }
    const double scale = geometry::distance(points[k_eye_right], points[k_eye_left]) / std::sqrt(square);
    const double eyes = (at(2, k_eye_right) + at(2, k_eye_left)) / 2;
    for (std::size_t i = 0; i < k_ibug_points; ++i) depths.push_back((eyes - at(2, i)) * scale);
    // The tip of a nose stands out by a share of the eyes' distance, whoever it is.
    const double nose = (eyes - at(2, k_nose_tip)) / std::sqrt(square);
    const bool sound = std::all_of(depths.begin(), depths.end(), usable_coordinate) && nose > 0.1 && nose < 1;
    return sound ? depths : std::vector<double>();
  }

 private:
  static constexpr std::size_t k_eye_right = 36;  ///< outer corners
  static constexpr std::size_t k_eye_left = 45;
  static constexpr std::size_t k_nose_tip = 30;
  std::array<std::array<std::size_t, k_ibug_points>, 3> columns_{};
  bool there_ = false;
};

/// The columns pose_Rx, pose_Ry, pose_Rz: how the tracker found the head turned, radians; Rx Ry Rz as matrices, x
/// right, y down, z away. Files without them are common.
class OwnTurn {
 public:
  explicit OwnTurn(const CsvReader& table) {
    there_ = find_columns(table, columns_, [](std::size_t axis) { return std::string("pose_R") + "xyz"[axis]; });
  }

  [[nodiscard]] std::optional<glm::dmat3> rotation(const CsvReader& table,
                                                   const std::vector<std::string_view>& cells) const {
    if (!there_) return std::nullopt;
    std::array<double, 3> angle{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (columns_[axis] >= cells.size()) return std::nullopt;
      angle[axis] = table.number(cells[columns_[axis]]).value_or(k_most);
      if (!(std::abs(angle[axis]) < k_most)) return std::nullopt;
    }
    return geometry::rotation_about({1, 0, 0}, angle[0]) * geometry::rotation_about({0, 1, 0}, angle[1]) *
           geometry::rotation_about({0, 0, 1}, angle[2]);
  }

 private:
  static constexpr double k_most = 3.2;  ///< radians; a file in degrees would soon say more
  std::array<std::size_t, 3> columns_{};
  bool there_ = false;
};

/// The columns gaze_0_x, ... of the two eyes: unit vectors from them to what they look at, x right, y down, z away.
class OwnGaze {
 public:
  explicit OwnGaze(const CsvReader& table) {
    there_ = true;
    for (std::size_t eye = 0; eye < 2; ++eye) {
      there_ = there_ && find_columns(table, columns_[eye], [eye](std::size_t axis) {
                 return "gaze_" + std::to_string(eye) + "_" + "xyz"[axis];
               });
    }
  }

  /// Relative to the head, which stands as the tracker says, or looks into the camera where it says nothing.
  [[nodiscard]] std::vector<animation::Gaze> read(const CsvReader& table, const std::vector<std::string_view>& cells,
                                                  const std::optional<glm::dmat3>& head) const {
    std::vector<animation::Gaze> gaze;
    for (std::size_t eye = 0; eye < 2 && there_; ++eye) {
      glm::dvec3 way(0);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t column = columns_[eye][axis];
        way[static_cast<int>(axis)] =
            column < cells.size() ? table.number(cells[column]).value_or(std::nan("")) : std::nan("");
      }
      if (head) way = glm::transpose(*head) * way;
      // Nobody looks backwards; a file of zeros says nothing.
      constexpr double k_least = 0.1;
      if (!(-way.z > k_least) || !(std::abs(way.x) < 2) || !(std::abs(way.y) < 2)) return {};
      gaze.push_back({base::atan2(way.x, -way.z), base::atan2(way.y, -way.z)});
    }
    return gaze;
  }

 private:
  std::array<std::array<std::size_t, 3>, 2> columns_{};
  bool there_ = false;
};

/// The columns AU01_r, ..., intensities of action units from 0 to 5. Files without them are common.
class OwnWords {
 public:
  explicit OwnWords(const CsvReader& table) {
    const auto names = table.columns();
    for (std::size_t c = 0; c < names.size(); ++c) {
      const std::string name(names[c]);
      if (name.size() == 6 && name.starts_with("AU") && name.ends_with("_r")) {
        unit_names.push_back(name.substr(0, 4));
        units_.push_back(c);
      }
    }
  }

  [[nodiscard]] animation::TrackerSays read(const CsvReader& table, const std::vector<std::string_view>& cells) const {
    animation::TrackerSays says;
    const auto at = [&](std::size_t column) {
      return column < cells.size() ? table.number(cells[column]).value_or(std::nan("")) : std::nan("");
    };
    constexpr double k_most = 5;
    for (std::size_t i = 0; i < units_.size(); ++i) {
      const double value = at(units_[i]) / k_most;
      says.units.push_back(std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0);
      if (unit_names[i] == "AU45" && std::isfinite(value)) says.closing = says.units.back();
    }
    return says;
  }

  std::vector<std::string> unit_names;

 private:
  std::vector<std::size_t> units_;
};

}  // namespace

base::Result<animation::PointTrack> read_openface_track(base::Bytes bytes) {
  auto table = CsvReader::open(base::as_text(bytes));
  if (!table) return table.error();
  const auto columns = find_point_columns(*table, k_ibug_points, [](std::size_t i, int axis) {
    constexpr std::array<const char*, 3> k_axes{"x_", "y_", "no column of depths "};
    return std::vector<std::string>{k_axes[static_cast<std::size_t>(axis)] + std::to_string(i)};
  });
  if (!columns) return columns.error();
  const SolidFace solid(*table);
  const OwnTurn turn(*table);
  const OwnWords words(*table);
  const OwnGaze gaze(*table);
  auto rows = read_point_rows(*table, *columns, [&](const auto& cells, TrackRow& row) {
    if (!row.why_held.empty()) return;
    row.depths = solid.depths(*table, cells, row.points);
    if (row.depths.empty()) row.depths = common_depths(row.points);
    row.rotation = turn.rotation(*table, cells);
    row.says = words.read(*table, cells);
    row.says.gaze = gaze.read(*table, cells, row.rotation);
  });
  if (!rows) return rows.error();
  std::vector<std::string> notes = columns->notes;
  auto best = rows_of_best_face(std::move(rows).value(), notes);
  take_small_units(best);
  auto track = make_track(std::move(best), k_ibug_points, k_common_fps);
  if (!track) return track;
  track->unit_names = words.unit_names;
  return noted(std::move(track), notes);
}

TrackFormat openface_format() {
  return {"openface", 1, false,
          [](const TrackText& text) {
            if (!text.table || text.has("x_467")) return false;
            if (!text.has("x_0")) return has_units(*text.table);
            return text.has("success") || text.has("gaze_0_x") || text.has("confidence");
          },
          [](base::Bytes bytes, std::optional<PictureSize>) {
            const TrackText text(bytes);
            const bool units = text.table && !text.has("x_0") && has_units(*text.table);
            return units ? as_track(read_openface_units(bytes)) : as_track(read_openface_track(bytes));
          }};
}

}  // namespace penpose::io
