#include "core/tracking/track_setup.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/text/closest_name.h"
#include "core/base/text/joined.h"
#include "core/document/features/known_heads.h"
#include "core/rig/control_names.h"
#include "core/tracking/driven_controls.h"

namespace penpose::tracking {
namespace {

/// Curves of the model by name.
class References {
 public:
  References(const document::Model& model, const std::vector<io::VertexCurve>& landmarks) : model_(model) {
    add(landmarks);
    // What was corrected comes before what it corrects.
    for (const auto* curves : {&model.features, &model.curves}) {
      for (const document::NamedCurve& curve : *curves) {
        std::vector<posing::CurvePoint> points;
        for (const mesh::MeshPoint& p : curve.points) {
          points.push_back(posing::at_mesh_point(p, model.mesh->triangles()));
        }
        if (!points.empty()) add(curve.name, std::move(points));
      }
    }
    add(document::known_head_curves(model));
  }

  /// The first curve of that name; landmark lists call the border of the lips its outer edge.
  [[nodiscard]] const std::vector<posing::CurvePoint>* find(const std::string& name) const {
    for (const std::string& wanted : {name, name + "_outer"}) {
      const auto at = std::find(names_.begin(), names_.end(), wanted);
      if (at != names_.end()) return &curves_[static_cast<std::size_t>(at - names_.begin())];
    }
    return nullptr;
  }
  [[nodiscard]] base::Error missing(const std::string& name, std::string place) const {
    const auto close = base::closest_name(name, names_);
    std::string remedy = close            ? "did you mean " + *close + "?"
                         : names_.empty() ? "list its vertices in the map, or give a file of curves"
                                          : "`penpose info` lists the model's curves";
    return {"the model has no curve \"" + name + "\"", std::move(place), std::move(remedy)};
  }

 private:
  void add(const std::vector<io::VertexCurve>& curves) {
    for (const io::VertexCurve& curve : curves) {
      std::vector<posing::CurvePoint> points;
      for (const std::uint32_t v : curve.vertices) {
        if (v < model_.mesh->vertex_count()) points.push_back(posing::at_vertex(v));
      }
      if (points.size() == curve.vertices.size()) add(curve.name, std::move(points));
    }
  }
  void add(std::string name, std::vector<posing::CurvePoint> points) {
    names_.push_back(std::move(name));
    curves_.push_back(std::move(points));
  }

  const document::Model& model_;
  std::vector<std::string> names_;
  std::vector<std::vector<posing::CurvePoint>> curves_;
};

const animation::TrackGroup* group_of(const animation::PointTrack& track, const std::string& name) {
  const auto found = std::find_if(track.groups.begin(), track.groups.end(),
                                  [&](const animation::TrackGroup& group) { return group.name == name; });
  return found == track.groups.end() ? nullptr : &*found;
}

base::Result<std::vector<std::size_t>> points_of_group(const animation::PointTrack& track, const std::string& name,
                                                       std::string place) {
  const auto* group = group_of(track, name);
  if (group == nullptr) {
    std::vector<std::string> names;
    for (const auto& one : track.groups) names.push_back(one.name);
    const auto close = base::closest_name(name, names);
    return base::Error{"the track has no curve \"" + name + "\"", std::move(place),
                       close ? "did you mean " + *close + "?" : "name a curve of the track, or list point numbers"};
  }
  std::vector<std::size_t> points(group->count);
  std::iota(points.begin(), points.end(), group->first);
  return points;
}

/// `bundled`: names that the track lacks are passed over.
base::Status find_points(const animation::PointTrack& track, const io::MapPoints& named, bool bundled,
                         const std::string& place, std::vector<std::size_t>& out) {
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (const auto* point = std::get_if<std::size_t>(&named[i])) {
      out.push_back(*point);
      continue;
    }
    const std::string& name = std::get<std::string>(named[i]);
    if (bundled && group_of(track, name) == nullptr) continue;
    auto points = points_of_group(track, name, place + "/" + std::to_string(i));
    if (!points) return points.error();
    out.insert(out.end(), points->begin(), points->end());
  }
  return base::Done{};
}

std::vector<std::string> names_in(const io::MapPoints& points) {
  std::vector<std::string> names;
  for (const auto& point : points) {
    if (const auto* name = std::get_if<std::string>(&point)) names.push_back(*name);
  }
  return names;
}

/// A track need not have all curves that a bundled map names, nor be without others: both are said. Error: it has none.
base::Status say_names(const animation::PointTrack& track, const io::MapFile& map, std::vector<std::string>& notes) {
  constexpr std::size_t k_most = 20;
  std::vector<std::string> wanted;
  std::vector<std::string> lacking;
  for (const io::MapCurve& curve : map.curves) {
    const auto* name = std::get_if<std::string>(&curve.track);
    if (name == nullptr) return base::Done{};  // its curves are made of numbered points
    wanted.push_back(*name);
    if (group_of(track, *name) == nullptr) lacking.push_back(*name);
  }
  if (!wanted.empty() && lacking.size() == wanted.size()) {
    return base::Error{"the track has none of the curves that the bundled map names", "map",
                       "name its curves " + base::joined(wanted) + ", or write a map"};
  }
  if (!lacking.empty())
    notes.push_back("the track has no curve " + base::joined(lacking) + "; what they drive is left out");
  const auto stable = names_in(map.stable);
  wanted.insert(wanted.end(), stable.begin(), stable.end());
  std::vector<std::string> unused;
  for (const animation::TrackGroup& group : track.groups) {
    if (unused.size() == k_most) break;
    if (std::find(wanted.begin(), wanted.end(), group.name) == wanted.end()) unused.push_back(group.name);
  }
  if (!unused.empty()) notes.push_back("the bundled map has no use for the track's " + base::joined(unused));
  return base::Done{};
}

/// A name of one's own map that no control has is misspelt.
base::Status check_free(const document::Model& model, const io::MapFile& map) {
  for (std::size_t i = 0; i < map.free.size(); ++i) {
    if (!rig::controls_named(model.rig->parameters(), map.free[i]).empty()) continue;
    std::vector<std::string> names;
    for (const rig::Parameter& parameter : model.rig->parameters()) names.push_back(parameter.name);
    const auto close = base::closest_name(map.free[i], names);
    return base::Error{"the model has no control '" + map.free[i] + "'", "/free/" + std::to_string(i),
                       close ? "did you mean '" + *close + "'?" : "`penpose info` lists the controls"};
  }
  return base::Done{};
}

std::vector<std::size_t> free_parameters(const document::Model& model, const io::MapFile& map) {
  std::vector<std::size_t> free;
  for (const std::string& name : map.free) {
    const auto named = rig::controls_named(model.rig->parameters(), name);
    free.insert(free.end(), named.begin(), named.end());
  }
  std::stable_sort(free.begin(), free.end());
  free.erase(std::unique(free.begin(), free.end()), free.end());
  if (free.empty()) {
    free.resize(model.rig->parameters().size());
    std::iota(free.begin(), free.end(), std::size_t{0});
  }
  return free;
}

base::Result<std::vector<posing::CurvePoint>> reference_of(const document::Model& model, const References& references,
                                                           const io::MapCurve& curve, const std::string& place) {
  if (const auto* name = std::get_if<std::string>(&curve.reference)) {
    const auto* found = references.find(*name);
    if (found == nullptr) return references.missing(*name, place);
    return *found;
  }
  std::vector<posing::CurvePoint> points;
  const auto& vertices = std::get<std::vector<std::uint32_t>>(curve.reference);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i] >= model.mesh->vertex_count()) {
      return base::Error{"vertex " + std::to_string(vertices[i]) + " does not exist; the model has " +
                             std::to_string(model.mesh->vertex_count()) + " vertices",
                         place + "/" + std::to_string(i), "use a map for this model"};
    }
    points.push_back(posing::at_vertex(vertices[i]));
  }
  return points;
}

}  // namespace

base::Result<animation::TrackSetup> make_setup(const document::Model& model, const animation::PointTrack& track,
                                               const io::MapFile& map, const std::vector<io::VertexCurve>& landmarks,
                                               std::vector<std::string>& notes) {
  const bool bundled = map.bundled;
  if (bundled) {
    if (auto names = say_names(track, map, notes); !names) return names.error();
  }
  const References references(model, landmarks);
  animation::TrackSetup setup;
  std::optional<base::Error> left_out;
  std::vector<std::string> meets;  // one a curve that is kept, as the next
  std::vector<std::string> touches;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < map.curves.size(); ++i) {
    const io::MapCurve& curve = map.curves[i];
    const std::string place = "/curves/" + std::to_string(i);
    animation::TrackedCurve tracked;
    tracked.weight = curve.weight;
    tracked.gain = curve.gain;
    if (const auto* name = std::get_if<std::string>(&curve.track)) {
      if (bundled && group_of(track, *name) == nullptr) continue;  // say_names says so
      auto points = points_of_group(track, *name, place + "/track");
      if (!points) return points.error();
      tracked.points = std::move(points).value();
    } else {
      tracked.points = std::get<std::vector<std::size_t>>(curve.track);
    }
    if (auto found = find_points(track, curve.anchor, bundled, place + "/anchor", tracked.anchor); !found) {
      return found.error();
    }
    auto reference = reference_of(model, references, curve, place + "/reference");
    if (!reference) {
      if (!bundled) return reference.error();
      left_out = reference.error();
      notes.push_back(left_out->what + "; what drives it is left out");
      continue;
    }
    tracked.reference = std::move(reference).value();
    setup.curves.push_back(std::move(tracked));
    meets.push_back(curve.meets);
    touches.push_back(curve.touches);
    const auto* name = std::get_if<std::string>(&curve.reference);
    names.push_back(name == nullptr ? "" : *name);
  }
  for (std::size_t i = 0; i < meets.size(); ++i) {
    for (const bool meet : {true, false}) {
      const std::string& wanted = meet ? meets[i] : touches[i];
      if (wanted.empty()) continue;
      const auto at = std::find(names.begin(), names.end(), wanted);
      if (at == names.end() && !bundled) {
        return base::Error{"no curve of the map has the reference '" + wanted + "'",
                           "/curves/" + std::to_string(i) + (meet ? "/meets" : "/touches"),
                           "name the reference of another curve"};
      }
      if (at == names.end()) continue;
      (meet ? setup.curves[i].meets : setup.curves[i].touches) = static_cast<std::size_t>(at - names.begin());
    }
  }
  if (setup.curves.empty() && left_out) {
    left_out->what = "the model has none of the curves that the bundled map names";
    left_out->place = "map";
    left_out->remedy = "write a map with the model's vertices, or give a file of curves";
    return *left_out;
  }
  if (auto found = find_points(track, map.stable, bundled, "/stable", setup.points.stable); !found) {
    return found.error();
  }
  if (auto found = find_points(track, map.turning, bundled, "/turning", setup.points.turning); !found) {
    return found.error();
  }
  if (bundled && setup.points.stable.empty() && !map.stable.empty()) {
    notes.push_back("the head counts as still: the track has no curve of the names " +
                    base::joined(names_in(map.stable)));
  }
  if (auto found = check_free(model, map); !bundled && !found) return found.error();
  setup.free = free_parameters(model, map);
  setup.rest = rig::rest_pose(*model.rig);
  setup.components.assign(model.mesh->components().begin(), model.mesh->components().end());
  return setup;
}

std::vector<animation::UnitControl> unit_controls(const document::Model& model, const animation::PointTrack& track) {
  // Those that a picture shows well, of the Facial Action Coding System (Ekman and Friesen 1978).
  constexpr std::array<std::string_view, 16> k_units{"AU01", "AU02", "AU04", "AU06", "AU09", "AU10", "AU12", "AU14",
                                                     "AU15", "AU17", "AU18", "AU20", "AU22", "AU24", "AU26", "AU28"};
  std::vector<animation::UnitControl> controls;
  for (std::size_t u = 0; u < track.unit_names.size(); ++u) {
    if (std::find(k_units.begin(), k_units.end(), track.unit_names[u]) == k_units.end()) continue;
    for (const DrivenControl& one : driven_controls(model, track.unit_names[u])) {
      const auto same = [&](const animation::UnitControl& other) { return other.parameter == one.parameter; };
      if (std::none_of(controls.begin(), controls.end(), same)) controls.push_back({u, one.parameter});
    }
  }
  return controls;
}

}  // namespace penpose::tracking
