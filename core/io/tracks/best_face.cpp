#include "core/io/tracks/best_face.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace penpose::io {
namespace {

/// Rows of the file by their places in it.
using FacePlaces = std::vector<std::size_t>;

struct Face {
  std::int64_t id = 0;
  double seen = 0;  ///< sum of confidences
  FacePlaces rows;
};

bool shows_face(const FaceRow& row) { return row.row.why_held.empty(); }

/// Best first; of equals the one of the lowest number.
std::vector<Face> faces_of(const std::vector<FaceRow>& rows) {
  std::map<std::int64_t, Face> by_id;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Face& face = by_id[rows[i].face];
    face.id = rows[i].face;
    face.seen += shows_face(rows[i]) ? rows[i].row.confidence : 0.0;
    face.rows.push_back(i);
  }
  std::vector<Face> faces;
  for (auto& [id, face] : by_id) faces.push_back(std::move(face));
  std::stable_sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.seen > b.seen; });
  return faces;
}

/// What tells frames apart, one a row, or nothing where all rows say the same or one says nothing.
std::vector<double> frame_keys(const std::vector<FaceRow>& rows) {
  const auto keys = [&](auto&& key_of) {
    std::vector<double> all;
    for (const FaceRow& row : rows) {
      const std::optional<double> key = key_of(row.row);
      if (!key || !std::isfinite(*key)) return std::vector<double>();
      all.push_back(*key);
    }
    const bool differ = std::any_of(all.begin(), all.end(), [&](double key) { return key != all.front(); });
    return differ ? all : std::vector<double>();
  };
  auto numbers = keys(
      [](const TrackRow& row) { return row.frame ? std::optional(static_cast<double>(*row.frame)) : std::nullopt; });
  return numbers.empty() ? keys([](const TrackRow& row) { return row.time_s; }) : numbers;
}

/// Joins the faces of a table to one.
class Joining {
 public:
  Joining(std::vector<FaceRow>& rows, const std::vector<double>& keys) : rows_(rows), keys_(keys) {}

  /// Takes the face unless it is seen in a frame in which one that was taken is. Returns the place of the first row
  /// that shows it, or nothing.
  std::optional<std::size_t> take(const Face& face) {
    const auto showing = [&](std::size_t i) { return shows_face(rows_[i]); };
    const auto known = [&](std::size_t i) { return showing(i) && shown_.contains(keys_[i]); };
    const auto first = std::find_if(face.rows.begin(), face.rows.end(), showing);
    if (first == face.rows.end() || std::any_of(face.rows.begin(), face.rows.end(), known)) return std::nullopt;
    for (const std::size_t i : face.rows) {
      if (showing(i)) shown_.insert(keys_[i]);
    }
    taken_.insert(face.id);
    return *first;
  }

  /// The rows of the faces that were taken, and for each frame that shows none of them one that is held.
  std::vector<TrackRow> rows() {
    FacePlaces kept;
    std::set<double> covered = shown_;
    const auto keep_those = [&](bool taken) {
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (taken_.contains(rows_[i].face) != taken) continue;
        if (taken && shows_face(rows_[i])) {
          kept.push_back(i);
        } else if (covered.insert(keys_[i]).second) {
          if (shows_face(rows_[i])) hold(rows_[i]);
          kept.push_back(i);
        }
      }
    };
    keep_those(true);
    keep_those(false);
    std::stable_sort(kept.begin(), kept.end());
    if (faces_grow()) {
      std::stable_sort(kept.begin(), kept.end(), [&](std::size_t a, std::size_t b) { return keys_[a] < keys_[b]; });
    }
    std::vector<TrackRow> result;
    for (const std::size_t i : kept) result.push_back(std::move(rows_[i].row));
    return result;
  }

 private:
  static void hold(FaceRow& row) {
    row.row.why_held = "only face " + std::to_string(row.face) + " is seen, not the one that is read";
    row.row.points.clear();
    row.row.depths.clear();
    row.row.rotation.reset();
    row.row.says = {};
  }

  /// Whether the frames of each face come in order; then they can be put in order all together, as in a table of one
  /// face after the other.
  [[nodiscard]] bool faces_grow() const {
    std::map<std::int64_t, double> last;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto [before, first] = last.emplace(rows_[i].face, keys_[i]);
      if (!first && keys_[i] < before->second) return false;
      before->second = keys_[i];
    }
    return true;
  }

  std::vector<FaceRow>& rows_;
  const std::vector<double>& keys_;
  std::set<double> shown_;  ///< frames in which a face is seen that was taken
  std::set<std::int64_t> taken_;
};

std::vector<TrackRow> rows_of(const Face& face, std::vector<FaceRow>& rows) {
  std::vector<TrackRow> result;
  for (const std::size_t i : face.rows) result.push_back(std::move(rows[i].row));
  return result;
}

}  // namespace

std::vector<TrackRow> rows_of_best_face(std::vector<FaceRow> rows, std::vector<std::string>& notes) {
  if (rows.empty()) return {};
  const std::vector<Face> faces = faces_of(rows);
  const Face& best = faces.front();
  if (faces.size() == 1) return rows_of(best, rows);
  const std::string name = "face " + std::to_string(best.id);
  const std::string which = "of " + std::to_string(faces.size()) + " faces, " + name + " is seen best and is read";
  const std::vector<double> keys = frame_keys(rows);
  if (keys.empty() || !(best.seen > 0)) {
    notes.push_back(which);
    return rows_of(best, rows);
  }
  Joining joining(rows, keys);
  joining.take(best);
  constexpr std::size_t k_most_notes = 5;
  std::vector<std::string> joined;
  std::size_t count = 0;
  for (std::size_t f = 1; f < faces.size(); ++f) {
    const auto first = joining.take(faces[f]);
    if (!first || ++count > k_most_notes) continue;
    joined.push_back("line " + std::to_string(rows[*first].row.line) + ": face " + std::to_string(faces[f].id) +
                     " is never seen together with " + name + "; it is read as the same face, lost and found");
  }
  if (count + 1 < faces.size()) notes.push_back(which);
  notes.insert(notes.end(), joined.begin(), joined.end());
  if (count > k_most_notes) notes.push_back("and " + std::to_string(count - k_most_notes) + " faces more like these");
  return joining.rows();
}

}  // namespace penpose::io
