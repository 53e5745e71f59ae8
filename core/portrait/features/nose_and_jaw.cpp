#include "core/portrait/features/nose_and_jaw.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/math.h"
#include "core/portrait/features/smooth_path.h"
#include "core/portrait/surface/ray_walk.h"

namespace penpose::portrait {
namespace {

// Lengths are shares of the distance of the eyes.
constexpr double k_base_reach = 0.24, k_base_wander = 0.06;
constexpr double k_hollow_chord = 0.04;
constexpr double k_clear_hollow = 0.6;  ///< as a share of the deepest
constexpr double k_tip_least = 0.12;    ///< a tip protrudes this far before what lies between the eyes
constexpr std::size_t k_bridge_points = 15, k_base_points = 19;
constexpr std::size_t k_jaw_rays = 61, k_jaw_steps = 90;
constexpr double k_jaw_from = 0.45, k_jaw_to = 1.7, k_jaw_chord = 0.07;
constexpr double k_jaw_rise = 0.1;  ///< of the middle of the rays over the mouth
constexpr double k_edge = 0.06;
/// Where an artist draws the edge of a jaw is a matter of taste.
constexpr double k_of_jaw = 0.4, k_of_chin = 0.45;
constexpr double k_chin_reach = 0.42;

using Walk = std::vector<std::optional<SurfacePlace>>;

double px_of(const FaceSurface& surface, const std::array<Eye, 2>& eyes) {
  return geometry::distance(eyes[0].centre, eyes[1].centre) / surface.image().px();
}

/// The uppermost clear hollow of a column between two rows: the lip's is as deep at times. Its turn is negative.
std::size_t hollow_of(const FaceSurface& surface, double column, int bottom, int top, double unit, Walk& walk,
                      double& turn) {
  walk.clear();
  for (int y = bottom; y <= top; ++y) walk.push_back(place_at(surface, column, y));
  if (walk.empty()) return 0;
  const auto turns = turns_of(walk, static_cast<std::size_t>(std::max(2.0, k_hollow_chord * unit)));
  const double least = *std::min_element(turns.begin(), turns.end());
  std::size_t at = turns.size() - 1;
  while (at > 0 && turns[at] > k_clear_hollow * least) --at;
  while (at > 0 && turns[at - 1] < turns[at]) --at;
  turn = turns[at];
  return at;
}

FoundLine base_of(const FaceSurface& surface, double middle, int mouth, int tip, double unit) {
  FoundLine line;
  Walk walk;
  double turn = 0;
  const int gap = (tip - mouth) / 4;
  const std::size_t hollow = hollow_of(surface, middle, mouth + gap, tip, unit, walk, turn);
  if (walk.empty() || !walk[hollow]) return line;
  const int row = mouth + gap + static_cast<int>(hollow);
  const int wander = static_cast<int>(k_base_wander * unit);
  std::vector<std::vector<double>> scores;
  std::vector<Walk> walks;
  for (std::size_t i = 0; i < k_base_points; ++i) {
    const double column = middle + k_base_reach * unit * (2.0 * static_cast<double>(i) / (k_base_points - 1) - 1.0);
    Walk& own = walks.emplace_back();
    for (int y = row - wander; y <= row + wander; ++y) own.push_back(place_at(surface, column, y));
    auto& score = scores.emplace_back(turns_of(own, static_cast<std::size_t>(std::max(2.0, 0.02 * unit))));
    for (std::size_t s = 0; s < score.size(); ++s) score[s] = own[s] ? -score[s] : -10.0;
  }
  const auto path = smooth_path(scores, 3, 0.01);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (walks[i][path[i]]) line.points.push_back(walks[i][path[i]]->point);
  }
  line.sureness = std::clamp(-turn / 0.6, 0.0, 1.0);
  return line;
}

struct FaceMiddle {
  double unit;         ///< px
  ModelPoint between;  ///< the eyes
  double column;       ///< of the picture
  MouthSeam::Column mouth;
};
FaceMiddle face_middle(const FaceSurface& surface, const std::array<Eye, 2>& eyes, const MouthSeam& seam) {
  const ModelPoint between = (eyes[0].centre + eyes[1].centre) * 0.5;
  return {px_of(surface, eyes), between, surface.image().column(between.x), seam.columns[seam.columns.size() / 2]};
}

}  // namespace

Nose find_nose(const FaceSurface& surface, const std::array<Eye, 2>& eyes, const MouthSeam& seam) {
  const FaceImage& image = surface.image();
  const auto [unit, between, middle, mouth] = face_middle(surface, eyes, seam);
  Nose nose;
  const int top = static_cast<int>(image.row(between.y));
  // Nearer to the mouth than a sixth of the way lies the lip.
  const int lowest = mouth.upper + (top - mouth.upper) / 4;
  std::optional<SurfacePlace> tip;
  int tip_row = 0;
  for (int y = lowest; y <= top; ++y) {
    const auto place = place_at(surface, middle, y);
    if (place && (!tip || place->place.z > tip->place.z)) {
      tip = place;
      tip_row = y;
    }
  }
  const auto root = place_at(surface, middle, top);
  if (!tip || !root || tip_row >= top) return nose;
  for (std::size_t i = 0; i < k_bridge_points; ++i) {
    const double share = static_cast<double>(i) / (k_bridge_points - 1);
    const auto place = place_at(surface, middle, top + share * (tip_row - top));
    if (place) nose.bridge.points.push_back(place->point);
  }
  const double rise = (tip->place.z - root->place.z) / (unit * image.px());
  const double sureness = std::min(eyes[0].upper.sureness, std::max(0.3, seam.sureness));
  nose.bridge.sureness = sureness * std::clamp(rise / k_tip_least, 0.0, 1.0);
  nose.base = base_of(surface, middle, mouth.upper, tip_row, unit);
  nose.base.sureness *= nose.bridge.sureness;
  return nose;
}

Jaw find_jaw(const FaceSurface& surface, const std::array<Eye, 2>& eyes, const MouthSeam& seam) {
  const FaceImage& image = surface.image();
  const auto [unit, between, x, mouth] = face_middle(surface, eyes, seam);
  const double y = mouth.upper + k_jaw_rise * unit;
  // From the height of the eyes on the right side, around below.
  const double up = base::atan2(image.row(between.y) - y, 1.1 * unit);
  const double step = (k_jaw_to - k_jaw_from) * unit / k_jaw_steps;
  const auto chord = static_cast<std::size_t>(std::max(2.0, k_jaw_chord * unit / step));
  std::vector<Walk> walks;
  std::vector<std::vector<double>> scores;
  for (std::size_t i = 0; i < k_jaw_rays; ++i) {
    const double share = static_cast<double>(i) / (k_jaw_rays - 1);
    const double angle = base::k_pi - up + share * (base::k_pi + 2.0 * up);
    const double dx = base::cos(angle);
    const double dy = base::sin(angle);
    Walk& walk = walks.emplace_back();
    double depth = 1e300;
    bool over = false;
    for (std::size_t s = 0; s < k_jaw_steps; ++s) {
      const double along = k_jaw_from * unit + static_cast<double>(s) * step;
      auto place = place_at(surface, x + along * dx, y + along * dy);
      // What is seen behind the edge of the face is a neck or an ear.
      if (place && depth < 1e299 && depth - place->place.z > 0.12 * unit * image.px()) over = true;
      if (place) depth = place->place.z;
      walk.push_back(over ? std::nullopt : place);
    }
    auto& score = scores.emplace_back(turns_of(walk, chord));
    // Beside the mouth the edge is where the face ends to the eye; below it the surface itself turns.
    std::size_t edge = 0;
    for (std::size_t s = 0; s < k_jaw_steps; ++s) edge = walk[s] ? s : edge;
    const double beside = std::clamp(1.5 * std::abs(dx) - 0.5, 0.0, 1.0);
    for (std::size_t s = 0; s < k_jaw_steps; ++s) {
      const double off = static_cast<double>(edge - std::min(edge, s)) * step / (k_edge * unit);
      score[s] = walk[s] ? (1.0 - beside) * score[s] + beside / (1.0 + off * off) : -1.0;
    }
  }
  const auto path = smooth_path(scores, 3, 0.01);
  Jaw jaw;
  double clear = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto& place = walks[i][path[i]];
    if (!place) continue;
    clear += std::clamp(scores[i][path[i]] / 0.5, 0.0, 1.0) / k_jaw_rays;
    jaw.jaw.points.push_back(place->point);
    if (std::abs(place->place.x - between.x) < k_chin_reach * unit * image.px()) {
      jaw.chin.points.push_back(place->point);
    }
  }
  const double even = std::min(seam.sureness + 0.2, eyes[0].upper.sureness);
  jaw.jaw.sureness = k_of_jaw * even * clear;
  jaw.chin.sureness = k_of_chin * even * clear;
  return jaw;
}

}  // namespace penpose::portrait
