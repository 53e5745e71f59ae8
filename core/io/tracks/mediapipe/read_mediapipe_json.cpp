#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/io/tracks/face_points.h"
#include "core/io/tracks/picture_scale.h"
#include "core/io/tracks/point_table.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/values/json_values.h"

namespace penpose::io {
namespace {

using MediapipeProblem = std::optional<base::Error>;

base::Error wrong_faces(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer), "export the track again, 468 or 478 points a face"};
}

bool is_point(const json::Json& value) {
  if (value.is_object()) return value.contains("x") && value.contains("y");
  return value.is_array() && (value.size() == 2 || value.size() == 3) && (value[0].is_number() || value[0].is_null());
}

/// What programs call the points of a face, or the faces of a frame. The first that a frame has counts.
constexpr std::array<const char*, 9> k_points_names{
    "landmarks", "faceLandmarks", "face_landmarks", "multi_face_landmarks", "multiFaceLandmarks", "points",
    "landmark",  "keypoints",     "faces"};

struct FoundFaces {
  const json::Json* value = nullptr;
  std::string place;
};

/// The points or faces of an object, or nothing.
FoundFaces find_points(const json::Json& object, const std::string& pointer) {
  for (const char* name : k_points_names) {
    if (const json::Json* value = json::find(object, name)) return {value, json::child(pointer, name)};
  }
  return {};
}

/// A list of points as long as a face has. A frame of so many faces, or a clip of so many frames of two or three
/// numbers, there is not.
bool is_face(const json::Json& value) {
  return value.is_array() && (value.size() == k_mediapipe_points || value.size() == k_mediapipe_iris_points) &&
         std::all_of(value.begin(), value.end(), is_point);
}

/// The frames of the file: a list, "frames", or what is a single frame by itself.
struct Frames {
  const json::Json* list = nullptr;  ///< null: `one` is the only frame, or there is none
  const json::Json* one = nullptr;
  std::string place;
};

Frames find_frames(const json::Json& json) {
  if (is_face(json)) return {nullptr, &json, ""};
  if (json.is_array()) return {&json, nullptr, ""};
  if (const json::Json* frames = json::find(json, "frames")) {
    if (is_face(*frames)) return {nullptr, frames, "/frames"};
    return {frames, nullptr, "/frames"};
  }
  const FoundFaces points = find_points(json, "");
  if (points.value == nullptr || !points.value->is_array()) return {nullptr, nullptr, "/frames"};
  // The result for one picture lists a face; what lists more of them is taken for a clip.
  const bool clip = points.value->size() > 1 && !is_face(*points.value);
  return clip ? Frames{points.value, nullptr, points.place} : Frames{nullptr, &json, ""};
}

/// A number or NaN.
double member(const json::Json& point, const char* name, std::size_t index) {
  const json::Json* value = point.is_object()      ? json::find(point, name)
                            : index < point.size() ? &point[index]
                                                   : nullptr;
  return value == nullptr ? std::nan("") : json::number(*value).value_or(std::nan(""));
}

/// One face of a frame. A point that is no number leaves `why_held`.
MediapipeProblem read_face(const json::Json& list, const std::string& pointer, TrackRow& out) {
  if (list.size() != k_mediapipe_points && list.size() != k_mediapipe_iris_points) {
    out.why_held = "a face of 468 or 478 points was expected, not of " + std::to_string(list.size());
    return std::nullopt;
  }
  bool depths = true;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!is_point(list[i])) return wrong_faces("a point was expected", json::child(pointer, i));
    const double x = member(list[i], "x", 0);
    const double y = member(list[i], "y", 1);
    const double z = member(list[i], "z", 2);
    if (!usable_coordinate(x) || !usable_coordinate(y)) {
      out.why_held = "a coordinate is missing or no number";
      out.points.clear();
      out.depths.clear();
      return std::nullopt;
    }
    out.points.push_back({x, y});
    out.depths.push_back(-z);
    depths = depths && usable_coordinate(z);
  }
  if (!depths) out.depths.clear();
  return std::nullopt;
}

double size_of(const TrackRow& row) {
  if (row.points.empty()) return -1;
  double low = row.points[0].x;
  double high = low;
  for (const auto& p : row.points) {
    low = std::min(low, p.x);
    high = std::max(high, p.x);
  }
  return high - low;
}

/// How far apart two faces are; those that cannot be compared are as far as can be.
double distance_of(const TrackRow& a, const TrackRow& b) {
  if (a.points.size() != b.points.size() || a.points.empty()) return 1e300;
  double sum = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i) sum += geometry::distance(a.points[i], b.points[i]);
  return sum;
}

class MediapipeReader {
 public:
  MediapipeProblem read_frame(const json::Json& value, const std::string& pointer, std::size_t index) {
    TrackRow row;
    row.line = index;
    FoundFaces found{&value, pointer};
    if (value.is_object()) {
      found = find_points(value, pointer);
      read_times(value, row);
      if (found.value == nullptr && !value.empty())
        row.why_held = "it has none of the lists \"landmarks\", \"faceLandmarks\", \"points\"";
    }
    const json::Json* points = found.value;
    const std::string& place = found.place;
    const bool nothing = points == nullptr || points->is_null() || (points->is_array() && points->empty());
    if (!nothing && !points->is_array()) return wrong_faces("a list of points was expected", place);
    if (nothing) {
      if (row.why_held.empty()) row.why_held = "the tracker found no face";
    } else if (is_point((*points)[0])) {
      if (auto problem = read_face(*points, place, row)) return problem;
    } else if (auto problem = choose_face(*points, place, row)) {
      return problem;
    }
    if (row.why_held.empty() && !(row.confidence > 0)) row.why_held = "the tracker's confidence is 0";
    if (!row.why_held.empty()) row.points.clear();
    if (!row.points.empty() && count != 0 && row.points.size() != count) {
      row.why_held =
          "the face has " + std::to_string(row.points.size()) + " points, those before " + std::to_string(count);
      row.points.clear();
      row.depths.clear();
    }
    if (!row.points.empty()) {
      count = row.points.size();
      last_ = row;
    }
    rows.push_back(std::move(row));
    return std::nullopt;
  }

  std::vector<TrackRow> rows;
  std::size_t count = 0;
  bool several = false;

 private:
  static constexpr double k_latest = 1e19;  // nanoseconds since 1970 have 19 digits

  static void read_times(const json::Json& value, TrackRow& row) {
    const auto at = [&](const char* name) {
      const json::Json* found = json::find(value, name);
      auto n = found == nullptr ? std::nullopt : json::number(*found);
      if (found != nullptr && found->is_string()) n = base::parse_double(found->get_ref<const std::string&>());
      return n && std::abs(*n) < k_latest ? n : std::nullopt;
    };
    row.time_s = at("timestamp");
    if (!row.time_s) row.time_s = at("time");
    if (const auto ms = at("timestamp_ms")) row.time_s = *ms / 1000.0;
    row.confidence = json::find(value, "confidence") == nullptr ? 1.0 : at("confidence").value_or(0);
  }

  /// The face nearest to the one before, at first the largest.
  MediapipeProblem choose_face(const json::Json& faces, const std::string& pointer, TrackRow& row) {
    TrackRow best;
    double least = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      TrackRow face;
      const std::string place = json::child(pointer, i);
      // MediaPipe's own messages wrap the list once more.
      const json::Json* list = &faces[i];
      if (const FoundFaces inner = find_points(faces[i], place); inner.value != nullptr) list = inner.value;
      if (!list->is_array()) return wrong_faces("a list of points was expected", place);
      if (auto problem = read_face(*list, place, face)) return problem;
      const double cost = last_.points.empty() ? -size_of(face) : distance_of(face, last_);
      if (i == 0 || cost < least) {
        least = cost;
        best = std::move(face);
      }
    }
    several = several || faces.size() > 1;
    row.points = std::move(best.points);
    row.depths = std::move(best.depths);
    row.why_held = std::move(best.why_held);
    return std::nullopt;
  }

  TrackRow last_;
};

}  // namespace

base::Result<animation::PointTrack> read_mediapipe_json(base::Bytes bytes, std::optional<PictureSize> picture) {
  const auto json = read_json_values(bytes);
  if (!json) return json.error();
  const Frames frames = find_frames(*json);
  const bool listed = frames.list != nullptr && frames.list->is_array();
  if (!listed && frames.one == nullptr) return wrong_faces("a list of frames was expected", frames.place);
  const std::size_t count = listed ? frames.list->size() : 1;
  if (count > k_most_track_frames) return wrong_faces("a track has at most 1,000,000 frames", frames.place);
  const auto root_number = [&](const char* name) {
    const json::Json* found = json::find(*json, name);
    const auto n = found == nullptr ? std::nullopt : json::number(*found);
    return n && *n > 0 && *n <= 1e5 ? *n : 0.0;
  };
  const PictureSize own{root_number("width"), root_number("height")};
  if (!picture && own.width > 0 && own.height > 0) picture = own;
  MediapipeReader reader;
  for (std::size_t f = 0; f < count; ++f) {
    const json::Json& frame = listed ? (*frames.list)[f] : *frames.one;
    auto problem = reader.read_frame(frame, listed ? json::child(frames.place, f) : frames.place, f);
    if (!problem) continue;
    problem->place = "frame " + std::to_string(f) + " (" + problem->place + ")";
    return *problem;
  }
  std::vector<std::string> notes;
  if (reader.several) notes.emplace_back("several faces are seen; the one that was largest at first is followed");
  take_small_units(reader.rows);
  scale_to_picture(reader.rows, picture, notes);
  return noted(make_track(std::move(reader.rows), reader.count, root_number("fps"), RowName::frame), notes);
}

}  // namespace penpose::io
