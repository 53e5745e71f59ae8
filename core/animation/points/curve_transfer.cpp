#include "core/animation/points/curve_transfer.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/curve/distance.h"
#include "core/curve/polyline.h"

namespace penpose::animation {
namespace {

struct Matched {
  std::vector<PxPoint> tracked;            ///< in the neutral frame
  std::vector<posing::CurvePoint> points;  ///< one for each of them
  std::vector<PxPoint> places;
};

std::vector<PxPoint> about_middle(std::span<const PxPoint> line) {
  PxPoint sum;
  for (const PxPoint& p : line) sum = sum + p;
  const PxPoint middle = sum * (1.0 / static_cast<double>(line.size()));
  double square = 0;
  for (const PxPoint& p : line) square += (p.x - middle.x) * (p.x - middle.x) + (p.y - middle.y) * (p.y - middle.y);
  const double size = std::sqrt(square / static_cast<double>(line.size()));
  std::vector<PxPoint> result;
  for (const PxPoint& p : line) result.push_back((p - middle) * (size > 0 ? 1.0 / size : 1.0));
  return result;
}

double mismatch(std::span<const PxPoint> a, std::span<const PxPoint> b) {
  const auto x = about_middle(a);
  const auto y = about_middle(b);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const PxPoint d = x[i] - y[i];
    sum += d.x * d.x + d.y * d.y;
  }
  return sum;
}

bool closed(std::span<const PxPoint> line) {
  return line.size() > 3 && geometry::distance(line.front(), line.back()) < 0.1 * curve::arc_length(line);
}

/// The vertex of the model's curve that is nearest to each share of its length.
std::vector<std::size_t> at_shares(std::span<const double> own, std::span<const double> wanted, double shift,
                                   bool backwards) {
  std::vector<std::size_t> chosen;
  for (const double w : wanted) {
    double share = backwards ? 1.0 - w : w;
    share += shift;
    if (share > 1.0) share -= 1.0;
    std::size_t best = 0;
    for (std::size_t i = 1; i < own.size(); ++i) {
      if (std::abs(own[i] - share) < std::abs(own[best] - share)) best = i;
    }
    chosen.push_back(best);
  }
  return chosen;
}

/// Points between the curve's own, so that a sparse polyline is met where the tracked point lies: `k` pieces a segment,
/// each a mix of at most three vertices where both ends are single vertices.
void densify(std::vector<posing::CurvePoint>& points, std::vector<PxPoint>& places) {
  constexpr int k_pieces = 4;
  std::vector<posing::CurvePoint> dense;
  std::vector<PxPoint> dense_places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    dense.push_back(points[i]);
    dense_places.push_back(places[i]);
    if (i + 1 == points.size()) break;
    const auto single = [](const posing::CurvePoint& p) { return p.weight[0] == 1.0; };
    if (!single(points[i]) || !single(points[i + 1])) continue;
    for (int k = 1; k < k_pieces; ++k) {
      const double t = static_cast<double>(k) / k_pieces;
      dense.push_back({{points[i].vertex[0], points[i + 1].vertex[0], points[i].vertex[0]}, {1.0 - t, t, 0}});
      dense_places.push_back(places[i] * (1.0 - t) + places[i + 1] * t);
    }
  }
  points = std::move(dense);
  places = std::move(dense_places);
}

/// Errors: a curve without length.
base::Result<Matched> match(std::span<const PxPoint> tracked, std::vector<posing::CurvePoint> points,
                            std::vector<PxPoint> places) {
  densify(points, places);
  const auto own = curve::shares_of<PxPoint>(places);
  if (!own) return own.error();
  const auto wanted = curve::shares_of<PxPoint>(tracked);
  if (!wanted) return wanted.error();
  const bool loop = closed(places) && closed(tracked);
  const std::size_t shifts = loop ? 64 : 1;
  Matched best;
  double least = 0;
  for (std::size_t s = 0; s < shifts; ++s) {
    for (const bool backwards : {false, true}) {
      const auto chosen = at_shares(*own, *wanted, static_cast<double>(s) / static_cast<double>(shifts), backwards);
      Matched trial;
      trial.tracked.assign(tracked.begin(), tracked.end());
      for (const std::size_t i : chosen) {
        trial.points.push_back(points[i]);
        trial.places.push_back(places[i]);
      }
      const double difference = mismatch(tracked, trial.places);
      if (best.points.empty() || difference < least) {
        least = difference;
        best = std::move(trial);
      }
    }
  }
  return best;
}

/// Mean distance of one curve's points, but for its ends, from the other, as a share of its length.
double gap(std::span<const PxPoint> line, std::span<const PxPoint> other) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) sum += curve::distance_to(other, line[i]);
  const double count = static_cast<double>(std::max<std::size_t>(line.size(), 3) - 2);
  return sum / count / curve::arc_length(line);
}

/// How much more a curve has to move on the model than on the face to meet the other.
double meeting_gain(const Matched& curve, const Matched& other) {
  const double tracked = gap(curve.tracked, other.tracked);
  const double own = gap(curve.places, other.places);
  return tracked > 1e-6 && own > 1e-6 ? std::clamp(own / tracked, 0.5, 2.0) : 1.0;
}

/// The roll between all tracked curves and the model's, from the similarity of least squares.
void find_roll(std::span<const Matched> curves, Transfer& out) {
  PxPoint from;
  PxPoint to;
  double count = 0;
  for (const Matched& curve : curves) {
    for (std::size_t i = 0; i < curve.tracked.size(); ++i) {
      from = from + curve.tracked[i];
      to = to + curve.places[i];
      count += 1;
    }
  }
  from = from * (1.0 / count);
  to = to * (1.0 / count);
  double real = 0;
  double imaginary = 0;
  for (const Matched& curve : curves) {
    for (std::size_t i = 0; i < curve.tracked.size(); ++i) {
      const PxPoint a = curve.tracked[i] - from;
      const PxPoint b = curve.places[i] - to;
      real += a.x * b.x + a.y * b.y;
      imaginary += a.x * b.y - a.y * b.x;
    }
  }
  const double size = std::sqrt(real * real + imaginary * imaginary);
  if (!(size > 0)) return;
  out.turn_cosine = real / size;
  out.turn_sine = imaginary / size;
}

/// Pairs the inner points of curves that touch, each with the one as far along the other.
void find_contacts(std::span<const TrackedCurve> curves, std::span<const Matched> matched, Transfer& out) {
  const std::vector<std::size_t> firsts = first_points(curves);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& other = curves[c].touches;
    if (!other || *other <= c || *other >= curves.size()) continue;
    const auto& a = matched[c].tracked;
    const auto& b = matched[*other].tracked;
    const bool backwards = geometry::distance(a.front(), b.front()) + geometry::distance(a.back(), b.back()) >
                           geometry::distance(a.front(), b.back()) + geometry::distance(a.back(), b.front());
    const std::size_t n = std::min(a.size(), b.size());
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const std::size_t from = i * (a.size() - 1) / (n - 1);
      const std::size_t to = i * (b.size() - 1) / (n - 1);
      out.contacts.push_back({firsts[c] + from, firsts[*other] + (backwards ? b.size() - 1 - to : to)});
    }
  }
}

}  // namespace

std::vector<std::size_t> first_points(std::span<const TrackedCurve> curves) {
  std::vector<std::size_t> firsts;
  std::size_t next = 0;
  for (const TrackedCurve& curve : curves) {
    firsts.push_back(next);
    next += curve.points.size();
  }
  return firsts;
}

base::Result<Transfer> make_transfer(const rig::Rig& rig, std::span<const double> rest, const PointTrack& track,
                                     const StillTrack& still, std::span<const TrackedCurve> curves,
                                     const geometry::Camera& camera) {
  std::vector<geometry::ModelPoint> positions(rig.vertex_count());
  rig.evaluate(rest, positions);
  const TrackFrame& neutral = track.frames[still.neutral];
  Transfer transfer;
  std::vector<Matched> matched;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const TrackedCurve& curve = curves[c];
    const std::string place = "/curves/" + std::to_string(c);
    const auto fail = [&](std::string what, std::string remedy) {
      return base::Error{std::move(what), place, std::move(remedy)};
    };
    std::vector<PxPoint> tracked;
    for (const std::size_t i : curve.points) {
      if (i >= track.point_count) {
        return fail("tracked point " + std::to_string(i) + " does not exist; the track has " +
                        std::to_string(track.point_count) + " points",
                    "use a map for this format");
      }
      tracked.push_back(neutral.points[i]);
    }
    std::vector<PxPoint> places;
    for (const posing::CurvePoint& point : curve.reference) {
      geometry::ModelPoint p(0);
      for (std::size_t k = 0; k < 3; ++k) {
        if (point.vertex[k] >= positions.size())
          return fail("vertex " + std::to_string(point.vertex[k]) + " does not exist", "use a map for this model");
        p += positions[point.vertex[k]] * point.weight[k];
      }
      const auto px = camera.project(p);
      if (!px) return fail("the model's curve lies behind the camera", "choose another view");
      places.push_back(*px);
    }
    if (tracked.size() < 2 || places.size() < 2) return fail("a curve needs at least two points", "name more points");
    const double tracked_length = curve::arc_length<PxPoint>(tracked);
    const double own_length = curve::arc_length<PxPoint>(places);
    if (!(tracked_length > 0) || !std::isfinite(tracked_length))
      return fail("the tracked curve has no length in frame " + std::to_string(still.neutral),
                  "choose another neutral frame");
    if (!(own_length > 0)) return fail("the model's curve has no length in this view", "choose another view");
    for (const std::size_t i : curve.anchor) {
      if (i < track.point_count) continue;
      return fail("tracked point " + std::to_string(i) + " does not exist; the track has " +
                      std::to_string(track.point_count) + " points",
                  "use a map for this format");
    }
    transfer.anchors.push_back(curve.anchor);
    auto fitted = match(tracked, curve.reference, places);
    if (!fitted) return fail(fitted.error().what, fitted.error().remedy);
    matched.push_back(std::move(fitted).value());
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      transfer.points.push_back(matched.back().points[i]);
      transfer.places.push_back(matched.back().places[i]);
      transfer.tracked.push_back(curve.points[i]);
      transfer.curve.push_back(c);
      transfer.weights.push_back(curve.weight);
      transfer.scale.push_back(curve.gain * own_length / tracked_length);
    }
  }
  if (matched.empty()) return base::Error{"there is no curve to follow", "/curves", "map at least one curve"};
  for (std::size_t i = 0; i < transfer.scale.size(); ++i) {
    const auto meets = curves[transfer.curve[i]].meets;
    if (meets && *meets < matched.size())
      transfer.scale[i] *= meeting_gain(matched[transfer.curve[i]], matched[*meets]);
  }
  find_roll(matched, transfer);
  find_contacts(curves, matched, transfer);
  return transfer;
}

void target_places(const Transfer& transfer, std::span<const PxPoint> offsets, double doubt,
                   std::span<geometry::PxPoint> targets) {
  std::vector<PxPoint> ground;
  for (const auto& anchor : transfer.anchors) {
    PxPoint sum;
    for (const std::size_t i : anchor) sum = sum + offsets[i];
    ground.push_back(anchor.empty() ? sum : sum * (doubt / static_cast<double>(anchor.size())));
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const PxPoint c = offsets[transfer.tracked[i]] - ground[transfer.curve[i]];
    const PxPoint turned{transfer.turn_cosine * c.x - transfer.turn_sine * c.y,
                         transfer.turn_sine * c.x + transfer.turn_cosine * c.y};
    targets[i] = transfer.places[i] + turned * transfer.scale[i];
  }
}

}  // namespace penpose::animation
