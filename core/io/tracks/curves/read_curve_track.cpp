#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/json/loose_json.h"
#include "core/curve/polyline.h"
#include "core/io/tracks/point_table.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"

namespace penpose::io {
namespace {

using CurveTrackProblem = std::optional<base::Error>;

base::Error wrong_curves(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer), R"(write {"fps": 25, "frames": [{"curves": {NAME: [[x, y], ...]}}]})"};
}

/// One curve of a frame as the file has it.
struct SeenCurve {
  std::string name;
  std::vector<animation::PxPoint> points;
  std::string why_not;  ///< not empty: the points cannot be used
};

struct SeenFrame {
  TrackRow row;
  std::vector<SeenCurve> curves;
};

/// What a curve that is used has in every frame.
struct KnownCurve {
  std::size_t points = 0;   ///< in the first frame that shows it; 0: none does
  std::size_t shown = 0;    ///< number of frames that show it
  std::string first_place;  ///< JSON pointer
};

CurveTrackProblem read_points(const json::Json& list, const std::string& pointer, SeenCurve& curve) {
  if (list.is_null()) {
    curve.why_not = "is missing";
    return std::nullopt;
  }
  if (!list.is_array()) return wrong_curves("a list of points was expected", pointer);
  if (list.size() > 10000) return wrong_curves("a curve has at most 10,000 points", pointer);
  if (list.size() < 2) curve.why_not = list.empty() ? "is empty" : "has a single point";
  for (std::size_t i = 0; i < list.size(); ++i) {
    const json::Json& point = list[i];
    if (!point.is_null() && (!point.is_array() || point.size() != 2)) {
      return wrong_curves("a point [x, y] was expected", json::child(pointer, i));
    }
    std::array<double, 2> at{std::nan(""), std::nan("")};
    for (std::size_t axis = 0; axis < 2 && !point.is_null(); ++axis) {
      if (!point[axis].is_number() && !point[axis].is_null())
        return wrong_curves("a number was expected", json::child(pointer, i));
      at[axis] = json::number(point[axis]).value_or(at[axis]);
    }
    if (!usable_coordinate(at[0]) || !usable_coordinate(at[1])) curve.why_not = "has a point that is no number";
    curve.points.push_back({at[0], at[1]});
  }
  return std::nullopt;
}

class CurveTrackReader {
 public:
  CurveTrackProblem read_frame(const json::Json& value, const std::string& pointer) {
    SeenFrame& frame = frames_.emplace_back();
    TrackRow& row = frame.row;
    row.line = frames_.size() - 1;
    const json::Json* curves = nullptr;
    if (!value.is_null()) {
      if (!value.is_object()) return wrong_curves("an object was expected", pointer);
      for (const char* name : {"time", "confidence"}) {
        const json::Json* given = json::find(value, name);
        if (given == nullptr) continue;
        const bool time = name[0] == 't';
        if (!given->is_number() && !given->is_null())
          return wrong_curves("a number was expected", json::child(pointer, name));
        const auto n = json::number(*given);
        if (n && std::abs(*n) > 1e19) return wrong_curves("a number was expected", json::child(pointer, name));
        if (time) {
          row.time_s = n;
        } else {
          row.confidence = n.value_or(0);
        }
      }
      curves = json::find(value, "curves");
    }
    if (curves == nullptr || curves->is_null() || curves->empty()) {
      row.why_held = "the frame has no curves";
      return std::nullopt;
    }
    const std::string place = json::child(pointer, "curves");
    if (!curves->is_object()) return wrong_curves("an object of curves was expected", place);
    if (!(row.confidence > 0)) row.why_held = "the confidence is 0";
    ++with_curves_;
    for (const auto& [name, points] : curves->items()) {
      SeenCurve& curve = frame.curves.emplace_back();
      curve.name = name;
      const std::string here = json::child(place, curve.name);
      if (auto problem = read_points(points, here, curve)) return problem;
      KnownCurve& known = known_.try_emplace(curve.name, KnownCurve{0, 0, here}).first->second;
      if (known_.size() > k_most_curves) return wrong_curves("a track has at most 1,000 curves", here);
      if (!curve.why_not.empty()) continue;
      ++known.shown;
      if (known.points == 0) known.points = curve.points.size();
    }
    return std::nullopt;
  }

  /// Curves that few frames have are left out, so that a name misspelt once does not hold all the others.
  base::Result<animation::PointTrack> finish(double fps, FrameOrder order) {
    std::vector<std::string> notes;
    std::vector<animation::TrackGroup> groups;
    std::size_t count = 0;
    for (const auto& [name, curve] : known_) {
      if (curve.shown == 0) return wrong_curves("curve " + name + " has no points in any frame", curve.first_place);
      if (2 * curve.shown < with_curves_) {
        notes.push_back("curve " + name + " is shown by " + std::to_string(curve.shown) + " of " +
                        std::to_string(with_curves_) + " frames only and left out (" + curve.first_place + ")");
        continue;
      }
      groups.push_back({name, count, curve.points});
      count += curve.points;
    }
    if (count * frames_.size() > k_most_points) return wrong_curves("a track has at most 50,000,000 points", "/frames");
    std::vector<TrackRow> rows;
    for (SeenFrame& frame : frames_) {
      if (frame.row.why_held.empty()) gather(frame, groups);
      if (order == FrameOrder::none) frame.row.time_s.reset();
      rows.push_back(std::move(frame.row));
    }
    auto track = make_track(std::move(rows), count, fps, RowName::frame);
    if (!track) return track;
    track->groups = std::move(groups);
    return noted(std::move(track), notes);
  }

 private:
  static constexpr std::size_t k_most_curves = 1000;
  static constexpr std::size_t k_most_points = 50'000'000;

  /// Puts the curves one after the other, each with its own number of points.
  static void gather(SeenFrame& frame, const std::vector<animation::TrackGroup>& groups) {
    TrackRow& row = frame.row;
    for (const animation::TrackGroup& group : groups) {
      // JSON objects come in the order of their names.
      const auto seen = std::lower_bound(frame.curves.begin(), frame.curves.end(), group.name,
                                         [](const SeenCurve& curve, const auto& name) { return curve.name < name; });
      const bool there = seen != frame.curves.end() && seen->name == group.name;
      const std::string problem = there ? seen->why_not : "is missing";
      if (!problem.empty()) row.why_held = "curve " + group.name + " " + problem;
      if (!row.why_held.empty()) break;
      if (seen->points.size() != group.count) {
        auto even = curve::resample<animation::PxPoint>(seen->points, group.count);
        if (!even) row.why_held = "curve " + group.name + " has no length";
        if (!even) break;
        seen->points = std::move(even).value();
      }
      row.points.insert(row.points.end(), seen->points.begin(), seen->points.end());
    }
    if (!row.why_held.empty()) row.points.clear();
  }

  std::vector<SeenFrame> frames_;
  std::map<std::string, KnownCurve, std::less<>> known_;
  std::size_t with_curves_ = 0;
};

}  // namespace

base::Result<animation::PointTrack> read_curve_track(base::Bytes bytes, FrameOrder order) {
  const auto json = json::parse_loose_json(bytes);
  if (!json) return json.error();
  const json::Json* frames = json::find(*json, "frames");
  if (frames == nullptr || !frames->is_array()) return wrong_curves("a list of frames was expected", "/frames");
  if (frames->size() > k_most_track_frames) return wrong_curves("a track has at most 1,000,000 frames", "/frames");
  double fps = 0;
  if (const json::Json* given = json::find(*json, "fps")) {
    fps = json::number(*given).value_or(0);
    if (!(fps > 0) || !(fps <= 10000))
      return wrong_curves("a frame rate above 0 and up to 10,000 was expected", "/fps");
  }
  // A point takes four bytes or more. Looked at before memory is taken for frames that show nothing.
  const auto empty =
      std::count_if(frames->begin(), frames->end(), [](const json::Json& frame) { return frame.is_null(); });
  if (static_cast<std::size_t>(empty) > most_gap_frames(bytes.size() / 4)) {
    return base::Error{"far more frames show no face than frames show one: " + std::to_string(empty) + " are empty",
                       "/frames", "cut the video to where the face is, and track it again"};
  }
  CurveTrackReader reader;
  for (std::size_t f = 0; f < frames->size(); ++f) {
    if (auto problem = reader.read_frame((*frames)[f], json::child("/frames", f))) return *problem;
  }
  return reader.finish(fps, order);
}

TrackFormat curves_format() {
  return {"curves", 4, false, [](const TrackText& text) { return text.json && text.mentions("\"curves\""); },
          [](base::Bytes bytes, std::optional<PictureSize>) { return as_track(read_curve_track(bytes)); }};
}

}  // namespace penpose::io
