#include "core/portrait/contour/contour_match.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::portrait {
namespace {

/// k of the doubt.
constexpr double k_reach = 4.0;
/// A point farther from every contour is none of theirs, px.
constexpr double k_farthest_px = 90.0;
/// Directions are alike from this cosine on; a right angle counts as so far away, px.
constexpr double k_like = 0.2, k_turned_px = 30.0;
/// The most places of a point that are thought of.
constexpr std::size_t k_most_places = 6;
/// What it costs to leave a contour, and to go on along another one where the first ends.
constexpr double k_leave = 3.0, k_other = 0.5;
/// What it costs to go along a contour by twice what was drawn.
constexpr double k_stretch = 0.4;

/// A place, how far along its contour, and what it costs there.
struct Candidate {
  ContourPlace place;
  double along = 0;
  double doubt = 0;
};

/// From two points before to two points behind: a tremor does not turn it.
PxPoint direction_at(std::span<const PxPoint> points, std::size_t i) {
  const PxPoint d = points[std::min(i + 2, points.size() - 1)] - points[i > 1 ? i - 2 : 0];
  const double length = geometry::distance(d, {});
  return length > 0.0 ? d * (1.0 / length) : PxPoint{0, 0};
}

/// Places of a contour that are nearer than those beside them.
void add_places(const PxPoint& at, const PxPoint& along, const SeenContour& contour, std::size_t number,
                std::vector<Candidate>& out) {
  std::optional<Candidate> best;
  const auto keep = [&] {
    if (best) out.push_back(*best);
    best.reset();
  };
  double last = 1e300;
  bool rising = false;
  for (std::size_t s = 0; s + 1 < contour.px.size(); ++s) {
    if (s % k_boxed == 0 && !contour.boxes[s / k_boxed].near(at, k_farthest_px)) {
      keep();
      last = 1e300;
      rising = false;
      s += k_boxed - 1;
      continue;
    }
    const PxPoint& a = contour.px[s];
    const PxPoint& b = contour.px[s + 1];
    const double length = contour.lengths[s + 1] - contour.lengths[s];
    if (!(length > 0.0)) continue;
    const double share = geometry::nearest_share(at, a, b);
    const PxPoint place = a + (b - a) * share;
    const double distance = geometry::distance(at, place);
    const double cosine = geometry::dot(along, b - a) / length;
    if (distance > k_farthest_px || cosine < k_like) {
      keep();
      last = 1e300;
      rising = false;
      continue;
    }
    const double turned = k_turned_px * (1.0 - cosine);
    const double off = std::sqrt(distance * distance + turned * turned);
    if (off > last) {
      rising = true;
    } else if (rising) {
      keep();
      rising = false;
    }
    last = off;
    if (best && best->doubt <= off) continue;
    const PxPoint normal{-(b.y - a.y) / length, (b.x - a.x) / length};
    best = Candidate{{number, s, share, place, normal}, contour.lengths[s] + share * length, off};
  }
  keep();
}

/// What it costs to go from one place to the next while so much is drawn.
double step_cost(const Candidate& from, const Candidate& to, std::span<const SeenContour> contours, double spacing) {
  if (from.place.line == to.place.line) {
    const SeenContour& contour = contours[from.place.line];
    double step = to.along - from.along;
    if (contour.closed && step < -0.5 * contour.lengths.back()) step += contour.lengths.back();
    if (step >= -0.5 * spacing) return std::min(k_leave, k_stretch * std::abs(step - spacing) / spacing);
  }
  const double apart = geometry::distance(from.place.px, to.place.px);
  return std::min(k_leave, k_other + k_stretch * std::abs(apart - spacing) / spacing);
}

ContourMatch matched_one_way(std::span<const PxPoint> points, double spacing, std::span<const SeenContour> contours) {
  const double looks = spacing / k_contour_look_px;
  const double none = looks * contour_doubt(k_farthest_px);
  struct State {
    double sum = 0;
    std::size_t from = 0;
  };
  std::vector<std::vector<Candidate>> places(points.size());
  std::vector<std::vector<State>> states(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<Candidate>& here = places[i];
    const PxPoint along = direction_at(points, i);
    for (std::size_t c = 0; c < contours.size(); ++c) add_places(points[i], along, contours[c], c, here);
    std::stable_sort(here.begin(), here.end(), [](const auto& a, const auto& b) { return a.doubt < b.doubt; });
    if (here.size() > k_most_places) here.resize(k_most_places);
    for (Candidate& one : here) one.doubt = looks * contour_doubt(one.doubt);
    // The last state is that no contour is near.
    states[i].resize(here.size() + 1);
    for (std::size_t k = 0; k <= here.size(); ++k) {
      State& state = states[i][k];
      const double doubt = k < here.size() ? here[k].doubt : none;
      state.sum = i == 0 ? doubt : 1e300;
      if (i == 0) continue;
      for (std::size_t j = 0; j < states[i - 1].size(); ++j) {
        const bool both = k < here.size() && j < places[i - 1].size();
        double step = 0.0;
        if (both) {
          step = step_cost(places[i - 1][j], here[k], contours, spacing);
        } else if (k < here.size() || j < places[i - 1].size()) {
          step = 0.5 * k_leave;
        }
        const double sum = states[i - 1][j].sum + step + doubt;
        if (sum < state.sum) state = {sum, j};
      }
    }
  }
  ContourMatch out;
  out.places.resize(points.size());
  const auto& last = states.back();
  std::size_t k = 0;
  for (std::size_t j = 1; j < last.size(); ++j) {
    if (last[j].sum < last[k].sum) k = j;
  }
  out.doubt = last[k].sum;
  for (std::size_t i = points.size(); i-- > 0;) {
    if (k < places[i].size()) out.places[i] = places[i][k].place;
    k = states[i][k].from;
  }
  return out;
}

}  // namespace

double contour_doubt(double distance_px) {
  const double share = distance_px / k_contour_doubt_px;
  return k_reach * base::log(1.0 + share * share / k_reach);
}

double contour_weight(double distance_px) {
  const double share = distance_px / k_contour_doubt_px;
  return 1.0 / (1.0 + share * share / k_reach);
}

ContourMatch match_contour(const EvenLine& line, std::span<const SeenContour> contours) {
  ContourMatch there = matched_one_way(line.points, line.spacing, contours);
  std::vector<PxPoint> back(line.points.rbegin(), line.points.rend());
  ContourMatch other = matched_one_way(back, line.spacing, contours);
  if (!(other.doubt < there.doubt)) return there;
  std::reverse(other.places.begin(), other.places.end());
  return other;
}

}  // namespace penpose::portrait
