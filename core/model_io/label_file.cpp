#include "core/model_io/label_file.h"

#include <algorithm>

#include "core/model_io/loose_json.h"
#include "core/model_io/read_track.h"

namespace penpose::model_io {
namespace {

base::Error wrong(const char* what, std::string pointer) {
  return {what, std::move(pointer), R"(write {"frames": [{"image": FILE, "curves": {NAME: [[x, y], ...]}}]})"};
}

void add_points(const animation::TrackGroup& group, std::vector<std::size_t>& out) {
  for (std::size_t i = 0; i < group.count; ++i) out.push_back(group.first + i);
}

}  // namespace

base::Result<LabelFile> read_label_file(base::Bytes bytes) {
  auto track = read_curve_track(bytes);
  if (!track) return track.error();
  const auto json = parse_loose_json(bytes);
  if (!json) return json.error();
  LabelFile file;
  file.track = std::move(track).value();
  const Json& frames = (*json)["frames"];
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const Json* image = find(frames[f], "image");
    if (image == nullptr || !image->is_string() || !file.track.frames[f].found()) {
      return wrong("a picture and its curves were expected", child("/frames", f));
    }
    file.images.push_back(image->get<std::string>());
  }
  const Json* features = find(*json, "features");
  if (features == nullptr) {
    for (const auto& group : file.track.groups) add_points(group, file.features.emplace_back());
    return file;
  }
  if (!features->is_array()) return wrong("a list was expected", "/features");
  for (std::size_t i = 0; i < features->size(); ++i) {
    const std::string here = child("/features", i);
    if (!(*features)[i].is_array()) return wrong("a list of names of curves was expected", here);
    auto& points = file.features.emplace_back();
    for (std::size_t k = 0; k < (*features)[i].size(); ++k) {
      const auto group = std::find_if(file.track.groups.begin(), file.track.groups.end(),
                                      [&](const auto& one) { return (*features)[i][k] == one.name; });
      if (group == file.track.groups.end()) return wrong("the name of a curve was expected", child(here, k));
      add_points(*group, points);
    }
  }
  return file;
}

std::string write_curve_track(const animation::PointTrack& track, double fps) {
  Json frames = Json::array();
  for (const animation::TrackFrame& frame : track.frames) {
    if (!frame.found()) {
      frames.push_back(nullptr);
      continue;
    }
    Json curves = Json::object();
    for (const animation::TrackGroup& group : track.groups) {
      Json& points = curves[group.name] = Json::array();
      for (std::size_t i = 0; i < group.count; ++i) {
        const auto& p = frame.points[group.first + i];
        points.push_back({p.x, p.y});
      }
    }
    frames.push_back({{"confidence", frame.confidence}, {"curves", std::move(curves)}});
  }
  return Json{{"fps", fps}, {"frames", std::move(frames)}}.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace penpose::model_io
