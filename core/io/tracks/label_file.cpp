#include "core/io/tracks/label_file.h"

#include <algorithm>

#include "core/base/json/loose_json.h"
#include "core/io/tracks/read_track.h"

namespace penpose::io {
namespace {

constexpr const char* k_mark_all = "mark every curve in every picture with two points or more";

base::Error wrong_labels(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer),
          R"(write {"frames": [{"image": FILE, "curves": {NAME: [[x, y], ...]}}]})"};
}

void add_points(const animation::TrackGroup& group, animation::LabelledFeature& out) {
  for (std::size_t i = 0; i < group.count; ++i) out.points.push_back(group.first + i);
  if (!out.name.empty()) out.name += "+";
  out.name += group.name;
}

std::string names_of(const std::vector<animation::TrackGroup>& groups) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(groups.size(), 20); ++i) {
    if (i > 0) text += ", ";
    text += groups[i].name;
  }
  return text;
}

/// Curves with other numbers of points than their first have been resampled, which may not be what was meant.
void note_counts(const json::Json& frames, LabelFile& file) {
  constexpr std::size_t k_most_notes = 20;
  std::size_t notes = 0;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const json::Json* curves = json::find(frames[f], "curves");
    for (const animation::TrackGroup& group : file.track.groups) {
      const json::Json* points = curves == nullptr ? nullptr : json::find(*curves, group.name.c_str());
      if (points == nullptr || points->size() == group.count) continue;
      if (++notes > k_most_notes) return;
      file.track.notes.push_back("curve " + group.name + " has " + std::to_string(points->size()) +
                                 " points in the picture " + file.images[f] + " and " + std::to_string(group.count) +
                                 " in " + file.images[0] + "; it is divided evenly into as many");
    }
  }
}

}  // namespace

base::Result<LabelFile> read_label_file(base::Bytes bytes) {
  auto track = read_curve_track(bytes, FrameOrder::none);
  if (!track) {
    base::Error error = track.error();
    if (error.place.empty()) return wrong_labels("no picture is labelled", "/frames");
    if (error.place.starts_with("frame ")) error.remedy = k_mark_all;
    return error;
  }
  const auto json = json::parse_loose_json(bytes);
  if (!json) return json.error();
  LabelFile file;
  file.track = std::move(track).value();
  const json::Json& frames = (*json)["frames"];
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const json::Json* image = json::find(frames[f], "image");
    const std::string here = json::child("/frames", f);
    if (image == nullptr || !image->is_string())
      return wrong_labels("the name of a picture was expected", json::child(here, "image"));
    file.images.push_back(image->get<std::string>());
    if (const auto& frame = file.track.frames[f]; !frame.found()) {
      return base::Error{frame.why_held + ", in the picture " + file.images.back(), json::child(here, "curves"),
                         k_mark_all};
    }
  }
  note_counts(frames, file);
  const json::Json* features = json::find(*json, "features");
  if (features == nullptr) {
    for (const auto& group : file.track.groups) add_points(group, file.features.emplace_back());
    return file;
  }
  if (!features->is_array()) return wrong_labels("a list was expected", "/features");
  for (std::size_t i = 0; i < features->size(); ++i) {
    const std::string here = json::child("/features", i);
    if (!(*features)[i].is_array() || (*features)[i].empty()) {
      return base::Error{"a list of names of curves was expected", here, R"(write "features": [[NAME, NAME], [NAME]])"};
    }
    auto& feature = file.features.emplace_back();
    for (std::size_t k = 0; k < (*features)[i].size(); ++k) {
      const json::Json& name = (*features)[i][k];
      const auto group = std::find_if(file.track.groups.begin(), file.track.groups.end(),
                                      [&](const auto& one) { return name == one.name; });
      if (group == file.track.groups.end()) {
        const std::string given = name.is_string() ? "no curve of all pictures is named " + name.get<std::string>()
                                                   : "the name of a curve was expected";
        return base::Error{given, json::child(here, k), "name one of " + names_of(file.track.groups)};
      }
      add_points(*group, feature);
    }
  }
  return file;
}

std::string write_curve_track(const animation::PointTrack& track, double fps) {
  json::Json frames = json::Json::array();
  for (const animation::TrackFrame& frame : track.frames) {
    if (!frame.found()) {
      frames.push_back(nullptr);
      continue;
    }
    json::Json curves = json::Json::object();
    for (const animation::TrackGroup& group : track.groups) {
      json::Json& points = curves[group.name] = json::Json::array();
      for (std::size_t i = 0; i < group.count; ++i) {
        const auto& p = frame.points[group.first + i];
        points.push_back({p.x, p.y});
      }
    }
    frames.push_back({{"confidence", frame.confidence}, {"curves", std::move(curves)}});
  }
  return json::Json{{"fps", fps}, {"frames", std::move(frames)}}.dump(-1, ' ', false,
                                                                      json::Json::error_handler_t::replace) +
         "\n";
}

}  // namespace penpose::io
