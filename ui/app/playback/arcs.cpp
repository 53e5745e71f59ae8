#include "ui/app/playback/arcs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve/distance.h"
#include "core/curve/polyline.h"
#include "core/document/time/arc.h"
#include "ui/app/playback/frames.h"

namespace penpose::app {
namespace {

constexpr std::size_t k_most_features = 6;
constexpr int k_most_arc_frames = 600;
constexpr double k_least_length_px = 6;
/// Ends of curves are shown that travel so much farther than their middles.
constexpr double k_ends_share = 1.5;
/// A stroke that stays so near to an arc pulls a frame along it: a share of what still is on it.
constexpr double k_on_arc_share = 0.6;

/// The frame of an arc nearest to a place.
struct NearFrame {
  std::size_t frame = 0;
  double px = 0;
};
NearFrame nearest_frame(const ShownArc& arc, const PxPoint& at) {
  NearFrame near{0, 1e300};
  for (std::size_t f = 0; f < arc.places.size(); ++f) {
    const double px = geometry::distance(arc.places[f], at);
    if (px < near.px) near = {f, px};
  }
  return near;
}

/// Where an arc is between two of its frames.
PxPoint place_at(const ShownArc& arc, double frame) {
  const auto f = std::min(static_cast<std::size_t>(frame), arc.places.size() - 2);
  return arc.places[f] + (arc.places[f + 1] - arc.places[f]) * (frame - static_cast<double>(f));
}

/// A smooth way from one number to another through a third in between, which never turns back.
double warped(double u, double at, double to) {
  const double slope = document::monotone_slope(to / at, (1 - to) / (1 - at));
  const document::KeySegment first{0, at, 0, to, to / at, slope, document::KeyKind::free};
  const document::KeySegment second{at, 1, to, 1, slope, (1 - to) / (1 - at), document::KeyKind::free};
  return document::value_at(u < at ? first : second, u);
}

/// The frames around one between whose keys the spacing follows.
std::pair<std::size_t, std::size_t> reach_of(const document::Document& document, const ShownArc& arc,
                                             std::size_t frame) {
  std::size_t from = 0;
  std::size_t to = arc.moments_s.size() - 1;
  constexpr double k_same_s = 1e-6;
  for (const document::PoseKey& key : document.timeline->keys) {
    const auto f =
        std::lower_bound(arc.moments_s.begin(), arc.moments_s.end(), key.time_s - k_same_s) - arc.moments_s.begin();
    const auto place = static_cast<std::size_t>(f);
    if (key.time_s < arc.moments_s[frame] - k_same_s) from = std::max(from, place);
    if (key.time_s > arc.moments_s[frame] + k_same_s) to = std::min(to, place);
  }
  return {from, to};
}

std::optional<document::RedrawArc> pulled(const document::Document& document, const ShownArc& arc, std::size_t frame,
                                          std::size_t to_frame) {
  auto [from, to] = reach_of(document, arc, frame);
  // Farther than the neighbouring keys the reach grows.
  from = std::min(from, to_frame > 0 ? to_frame - 1 : 0);
  to = std::max(to, std::min(to_frame + 1, arc.places.size() - 1));
  if (frame <= from || frame >= to || to_frame <= from || to_frame >= to) return std::nullopt;
  document::RedrawArc command;
  command.from_s = arc.moments_s[from];
  command.to_s = arc.moments_s[to];
  const auto frames = static_cast<double>(to - from);
  const double at = static_cast<double>(frame - from) / frames;
  const double now = static_cast<double>(to_frame - from) / frames;
  for (std::size_t f = from; f <= to; ++f) {
    const double share = static_cast<double>(f - from) / frames;
    command.shares.push_back(share);
    command.line.push_back(place_at(arc, static_cast<double>(from) + frames * warped(share, at, now)));
  }
  return command;
}

}  // namespace

std::vector<ShownArc> arcs_of(const document::Document& document, std::span<const portrait::FeatureCurve> features,
                              const document::View& view, int rate) {
  std::vector<ShownArc> arcs;
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  const auto& keys = document.timeline->keys;
  if (keys.size() < 2 || !camera) return arcs;
  std::vector<double> moments;
  const auto first = static_cast<int>(std::ceil(frame_of(keys.front().time_s, rate) - 1e-6));
  const auto last = static_cast<int>(std::floor(frame_of(keys.back().time_s, rate) + 1e-6));
  for (int f = first; f <= std::min(last, first + k_most_arc_frames); ++f) moments.push_back(time_of_frame(f, rate));
  if (moments.size() < 2) return arcs;
  const auto triangles = document.model->mesh->triangles();
  const auto poses = document::poses_of_timeline(document, moments);
  /// Its length; none that is shorter than `least_px` is shown.
  const auto add = [&](const mesh::MeshPoint& point, double least_px) {
    ShownArc arc{point, moments, {}};
    arc.places = document::arc_of(document, posing::at_mesh_point(point, triangles), *camera, poses);
    const double length = curve::arc_length(std::span<const PxPoint>(arc.places));
    if (length >= least_px) arcs.push_back(std::move(arc));
    return length;
  };
  for (const auto& curve : document.curves) {
    if (curve->role != document::PoseCurveRole::reference) continue;
    const double middle = add(curve->points[curve->points.size() / 2], k_least_length_px);
    // The ends of a mouth that smiles travel, and its middle does not.
    const double least_px = std::max(k_least_length_px, k_ends_share * middle);
    add(curve->points.front(), least_px);
    add(curve->points.back(), least_px);
  }
  if (!document.curves.empty()) return arcs;
  for (const portrait::FeatureCurve& curve : features) {
    const std::uint32_t vertex = portrait::nearest_vertex(curve.points[curve.points.size() / 2]);
    if (const auto point = mesh::mesh_point_at(vertex, triangles)) add(*point, k_least_length_px);
  }
  std::stable_sort(arcs.begin(), arcs.end(), [](const ShownArc& a, const ShownArc& b) {
    return curve::arc_length(std::span<const PxPoint>(a.places)) >
           curve::arc_length(std::span<const PxPoint>(b.places));
  });
  if (arcs.size() > k_most_features) arcs.resize(k_most_features);
  return arcs;
}

std::optional<document::RedrawArc> arc_meant(const document::Document& document, std::span<const ShownArc> arcs,
                                             const document::View& view, std::span<const PxPoint> line,
                                             std::span<const double> shares, bool paced, int rate, double within_px) {
  if (line.size() < 2) return std::nullopt;
  // A line begins and ends on the same arc. If several arcs are near its beginning, its end decides.
  const ShownArc* arc = nullptr;
  NearFrame begin;
  NearFrame end;
  double least = 3 * within_px;
  for (const ShownArc& one : arcs) {
    const NearFrame from = nearest_frame(one, line.front());
    const NearFrame to = nearest_frame(one, line.back());
    // Arcs of neighbouring lines lie over each other: one end may have been put on the other one's.
    const auto [nearer, farther] = std::minmax(from.px, to.px);
    if (nearer > within_px || farther > 2 * within_px || from.frame == to.frame || nearer + farther > least) continue;
    least = from.px + to.px;
    begin = from;
    end = to;
    arc = &one;
  }
  if (arc == nullptr) return std::nullopt;
  const bool stays = std::all_of(line.begin(), line.end(), [&](const PxPoint& at) {
    return curve::distance_to(arc->places, at) <= k_on_arc_share * within_px;
  });
  std::optional<document::RedrawArc> command;
  if (stays) {
    command = pulled(document, *arc, begin.frame, end.frame);
    if (!command) return std::nullopt;
  } else {
    command.emplace();
    const bool back = end.frame < begin.frame;
    command->from_s = arc->moments_s[std::min(begin.frame, end.frame)];
    command->to_s = arc->moments_s[std::max(begin.frame, end.frame)];
    command->line.assign(line.begin(), line.end());
    // It begins and ends on the arc, which goes on from there.
    command->line.front() = arc->places[begin.frame];
    command->line.back() = arc->places[end.frame];
    if (paced && shares.size() == line.size()) command->shares.assign(shares.begin(), shares.end());
    if (back) {
      std::reverse(command->line.begin(), command->line.end());
      std::reverse(command->shares.begin(), command->shares.end());
      for (double& share : command->shares) share = 1 - share;
    }
  }
  command->point = arc->point;
  command->view = view;
  command->rate = static_cast<std::uint32_t>(rate);
  return command;
}

std::span<const ShownArc> ArcsInSight::of(const document::Document& document,
                                          std::span<const portrait::FeatureCurve> features, const document::View& view,
                                          int rate) {
  if (timeline_ != document.timeline || model_ != document.model || curves_ != document.curves || !(view_ == view) ||
      rate_ != rate) {
    timeline_ = document.timeline;
    model_ = document.model;
    curves_ = document.curves;
    view_ = view;
    rate_ = rate;
    arcs_ = arcs_of(document, features, view, rate);
  }
  return arcs_;
}

}  // namespace penpose::app
