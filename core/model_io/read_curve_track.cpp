#include <algorithm>
#include <cmath>

#include "core/curve/polyline.h"
#include "core/model_io/json.h"
#include "core/model_io/point_table.h"
#include "core/model_io/read_track.h"

namespace penpose::model_io {
namespace {

using Problem = std::optional<base::Error>;

base::Error wrong(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer), R"(write {"fps": 25, "frames": [{"curves": {NAME: [[x, y], ...]}}]})"};
}

/// The points of one curve; nothing when one of them is no number.
Problem read_points(const Json& list, const std::string& pointer, std::optional<std::vector<animation::PxPoint>>& out) {
  if (!list.is_array() || list.size() < 2) return wrong("a curve of at least two points was expected", pointer);
  if (list.size() > 10000) return wrong("a curve has at most 10,000 points", pointer);
  out.emplace();
  bool good = true;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Json& point = list[i];
    if (point.is_null()) {
      good = false;
      continue;
    }
    if (!point.is_array() || point.size() != 2) return wrong("a point [x, y] was expected", child(pointer, i));
    const double x = number(point[0]).value_or(std::nan(""));
    const double y = number(point[1]).value_or(std::nan(""));
    if ((!point[0].is_number() && !point[0].is_null()) || (!point[1].is_number() && !point[1].is_null())) {
      return wrong("a number was expected", child(pointer, i));
    }
    good = good && usable_coordinate(x) && usable_coordinate(y);
    out->push_back({x, y});
  }
  if (!good) out.reset();
  return std::nullopt;
}

class Reader {
 public:
  Problem read_frame(const Json& value, const std::string& pointer, std::size_t index) {
    TrackRow row;
    row.line = index;
    const Json* curves = nullptr;
    if (!value.is_null()) {
      if (!value.is_object()) return wrong("an object was expected", pointer);
      for (const char* name : {"time", "confidence"}) {
        const Json* given = find(value, name);
        if (given == nullptr) continue;
        const auto n = number(*given);
        if (!n || std::abs(*n) > 1e12) return wrong("a number was expected", child(pointer, name));
        (name[0] == 't' ? row.time_s.emplace() : row.confidence) = *n;
      }
      curves = find(value, "curves");
    }
    if (curves == nullptr || curves->is_null()) {
      row.why_held = "the frame has no curves";
    } else if (!curves->is_object()) {
      return wrong("an object of curves was expected", child(pointer, "curves"));
    } else if (!(row.confidence > 0)) {
      row.why_held = "the confidence is 0";
    } else if (auto problem = read_curves(*curves, child(pointer, "curves"), row)) {
      return problem;
    }
    if (!row.why_held.empty()) row.points.clear();
    rows.push_back(std::move(row));
    return std::nullopt;
  }

  std::vector<TrackRow> rows;
  std::vector<animation::TrackGroup> groups;

 private:
  Problem read_curves(const Json& curves, const std::string& pointer, TrackRow& row) {
    if (curves.empty()) {
      row.why_held = "the frame has no curves";
      return std::nullopt;
    }
    std::vector<animation::TrackGroup> own;
    for (const auto& item : curves.items()) {
      const std::string& name = item.key();
      const Json& list = item.value();
      std::optional<std::vector<animation::PxPoint>> points;
      if (auto problem = read_points(list, child(pointer, name), points)) return problem;
      if (!points) {
        row.why_held = "curve " + name + " has a point that is no number";
        return std::nullopt;
      }
      own.push_back({name, row.points.size(), points->size()});
      const auto first = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.name == name; });
      if (first != groups.end() && points->size() != first->count) {
        auto even = curve::resample<animation::PxPoint>(*points, first->count);
        if (!even) {
          row.why_held = "curve " + name + " has no length";
          return std::nullopt;
        }
        points = std::move(even).value();
      }
      row.points.insert(row.points.end(), points->begin(), points->end());
    }
    if (groups.empty()) groups = own;
    // JSON objects come in the order of their names, so equal lists of names have equal places.
    const bool same = std::equal(own.begin(), own.end(), groups.begin(), groups.end(),
                                 [](const auto& a, const auto& b) { return a.name == b.name; });
    if (!same) return wrong("the frame has other curves than the first one", pointer);
    return std::nullopt;
  }
};

}  // namespace

base::Result<animation::PointTrack> read_curve_track(base::Bytes bytes) {
  const auto json = parse_json(bytes);
  if (!json) return json.error();
  const Json* frames = find(*json, "frames");
  if (frames == nullptr || !frames->is_array()) return wrong("a list of frames was expected", "/frames");
  if (frames->size() > k_most_track_frames) return wrong("a track has at most 1,000,000 frames", "/frames");
  double fps = 0;
  if (const Json* given = find(*json, "fps")) {
    fps = number(*given).value_or(0);
    if (!(fps > 0) || !(fps <= 10000)) return wrong("a frame rate above 0 was expected", "/fps");
  }
  Reader reader;
  for (std::size_t f = 0; f < frames->size(); ++f) {
    if (auto problem = reader.read_frame((*frames)[f], child("/frames", f), f)) return *problem;
  }
  const std::size_t count = reader.groups.empty() ? 0 : reader.groups.back().first + reader.groups.back().count;
  auto track = make_track(std::move(reader.rows), count, fps, RowName::frame);
  if (!track) return track;
  track->groups = std::move(reader.groups);
  return track;
}

}  // namespace penpose::model_io
