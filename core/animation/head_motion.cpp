#include "core/animation/head_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/math.h"
#include "core/geometry/rotation.h"

namespace penpose::animation {
namespace {

/// Stable points of the neutral frame about their middle, and where they are in another frame.
struct Fit {
  std::vector<glm::dvec3> shape;
  std::vector<PxPoint> seen;
  PxPoint pivot;
  bool solid = false;  ///< depths are known
};

PxPoint middle(std::span<const PxPoint> points) {
  PxPoint sum;
  for (const PxPoint& p : points) sum = sum + p;
  return sum * (1.0 / static_cast<double>(points.size()));
}

/// The similarity of least squares in closed form: with points as complex numbers about their middles, the factor is
/// sum(conj(x) p) / sum(|x|^2).
HeadTurn similarity(const Fit& fit) {
  const PxPoint seen_middle = middle(fit.seen);
  double real = 0;
  double imaginary = 0;
  double square = 0;
  for (std::size_t i = 0; i < fit.shape.size(); ++i) {
    const glm::dvec3& x = fit.shape[i];
    const PxPoint p = fit.seen[i] - seen_middle;
    real += x.x * p.x + x.y * p.y;
    imaginary += x.x * p.y - x.y * p.x;
    square += x.x * x.x + x.y * x.y;
  }
  HeadTurn turn;
  const double size = std::sqrt(real * real + imaginary * imaginary);
  turn.shift = seen_middle - fit.pivot;
  if (!(size > 1e-12 * square)) return turn;
  turn.scale = size / square;
  const double c = real / size;
  const double s = imaginary / size;
  turn.rotation = glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1);
  return turn;
}

using Row = std::array<double, 7>;  ///< six unknowns and the right side

/// Gauss's elimination with the largest pivot; nothing for a singular system.
std::optional<std::array<double, 6>> solve_six(std::array<Row, 6> a) {
  for (std::size_t k = 0; k < 6; ++k) {
    std::size_t best = k;
    for (std::size_t r = k + 1; r < 6; ++r) {
      if (std::abs(a[r][k]) > std::abs(a[best][k])) best = r;
    }
    if (!(std::abs(a[best][k]) > 1e-12)) return std::nullopt;
    std::swap(a[k], a[best]);
    for (std::size_t r = k + 1; r < 6; ++r) {
      const double factor = a[r][k] / a[k][k];
      for (std::size_t c = k; c < 7; ++c) a[r][c] -= factor * a[k][c];
    }
  }
  std::array<double, 6> x{};
  for (std::size_t k = 6; k-- > 0;) {
    double sum = a[k][6];
    for (std::size_t c = k + 1; c < 6; ++c) sum -= a[k][c] * x[c];
    x[k] = sum / a[k][k];
  }
  return x;
}

double extent_of(const Fit& fit) {
  double sum = 0;
  for (const glm::dvec3& x : fit.shape) sum += x.x * x.x + x.y * x.y;
  return std::sqrt(sum / static_cast<double>(fit.shape.size()));
}

/// One step of Gauss-Newton for the turn about three axes, the scale's logarithm and the shift. Turns out of the plane
/// are damped, so that stable points which lie nearly in a plane cannot throw them about.
bool refine(const Fit& fit, double extent, HeadTurn& turn) {
  std::array<Row, 6> normal{};
  for (std::size_t i = 0; i < fit.shape.size(); ++i) {
    const glm::dvec3 y = turn.rotation * fit.shape[i] * turn.scale;
    const std::array<std::array<double, 6>, 2> slope{
        {{0, y.z, -y.y, y.x, 1, 0}, {-y.z, 0, y.x, y.y, 0, 1}}};  // wx wy wz log(scale) shift
    const PxPoint left = fit.seen[i] - fit.pivot - turn.shift - PxPoint{y.x, y.y};
    const std::array<double, 2> rest{left.x, left.y};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      for (std::size_t r = 0; r < 6; ++r) {
        for (std::size_t c = 0; c < 6; ++c) normal[r][c] += slope[axis][r] * slope[axis][c];
        normal[r][6] += slope[axis][r] * rest[axis];
      }
    }
  }
  const double damping = 1e-3 * extent * extent * turn.scale * turn.scale;
  normal[0][0] += damping;
  normal[1][1] += damping;
  const auto step = solve_six(normal);
  if (!step) return false;
  const auto& s = *step;
  const glm::dvec3 axis{s[0], s[1], s[2]};
  double angle = geometry::length(axis);
  if (!std::isfinite(angle + s[3] + s[4] + s[5]) || std::abs(s[3]) > 2) return false;
  const double limit = 0.5;
  const glm::dvec3 direction = angle > 0 ? axis / angle : glm::dvec3(0, 0, 1);
  angle = std::min(angle, limit);
  turn.rotation = geometry::rotation_about(direction, angle) * turn.rotation;
  turn.scale *= base::exp(s[3]);
  turn.shift = turn.shift + PxPoint{s[4], s[5]};
  return angle > 1e-7 || std::abs(s[4]) + std::abs(s[5]) > 1e-6;
}

double residual(const Fit& fit, const HeadTurn& turn) {
  double sum = 0;
  for (std::size_t i = 0; i < fit.shape.size(); ++i) {
    const glm::dvec3 y = turn.rotation * fit.shape[i] * turn.scale;
    const PxPoint left = fit.seen[i] - fit.pivot - turn.shift - PxPoint{y.x, y.y};
    sum += left.x * left.x + left.y * left.y;
  }
  return std::sqrt(sum / static_cast<double>(fit.shape.size()));
}

HeadTurn find_turn(const Fit& fit, double extent) {
  HeadTurn turn = similarity(fit);
  turn.residual_px = residual(fit, turn);
  if (!fit.solid) return turn;
  HeadTurn solid = turn;
  constexpr int k_steps = 25;
  for (int i = 0; i < k_steps && refine(fit, extent, solid); ++i) {
  }
  solid.residual_px = residual(fit, solid);
  // Points that nearly lie in a plane may be fitted by a head that faces away; then the picture says nothing of depth.
  const bool sane = solid.rotation[2][2] > 0.3 && solid.residual_px <= turn.residual_px;
  return sane ? solid : turn;
}

/// The offset from the neutral place that, on a head standing like that, is seen as `apart`.
PxPoint turned_back(const HeadTurn& turn, PxPoint apart) {
  const auto& r = turn.rotation;
  const double determinant = r[0][0] * r[1][1] - r[1][0] * r[0][1];
  const double inverse = 1.0 / (turn.scale * determinant);
  return {(r[1][1] * apart.x - r[1][0] * apart.y) * inverse, (r[0][0] * apart.y - r[0][1] * apart.x) * inverse};
}

}  // namespace

base::Result<StillTrack> take_head_motion_out(const PointTrack& track, std::span<const std::size_t> stable,
                                              std::optional<std::size_t> neutral, double least_confidence) {
  const auto seen = [&](const TrackFrame& frame) { return frame.found() && frame.confidence >= least_confidence; };
  StillTrack still;
  if (neutral) {
    if (*neutral >= track.frames.size() || !seen(track.frames[*neutral])) {
      return base::Error{"frame " + std::to_string(*neutral) + " shows no face to start from", "",
                         "choose another neutral frame"};
    }
    still.neutral = *neutral;
  } else {
    const auto first = std::find_if(track.frames.begin(), track.frames.end(), seen);
    if (first == track.frames.end()) return base::Error{"no frame shows a face", "", "track the video again"};
    still.neutral = static_cast<std::size_t>(first - track.frames.begin());
  }
  const TrackFrame& start = track.frames[still.neutral];
  for (const std::size_t i : stable) {
    if (i < track.point_count) continue;
    return base::Error{"stable point " + std::to_string(i) + " does not exist; the track has " +
                           std::to_string(track.point_count) + " points",
                       "/stable", "use a map for this format"};
  }

  Fit fit;
  std::vector<PxPoint> places;
  for (const std::size_t i : stable) places.push_back(start.points[i]);
  const bool fitted = places.size() >= 2;
  if (!places.empty()) still.pivot = middle(places);
  fit.pivot = still.pivot;
  fit.solid = places.size() >= 4 && !start.depths.empty();
  double mean_depth = 0;
  for (const std::size_t i : stable) {
    if (fit.solid) mean_depth += start.depths[i] / static_cast<double>(stable.size());
  }
  const auto neutral_place = [&](std::size_t i) {
    const PxPoint p = start.points[i] - still.pivot;
    return glm::dvec3(p.x, p.y, fit.solid ? mean_depth - start.depths[i] : 0.0);
  };
  for (const std::size_t i : stable) fit.shape.push_back(neutral_place(i));
  const double extent = fitted ? extent_of(fit) : 1;
  if (!(extent > 1e-9)) {
    return base::Error{"all stable points are at one place", "/stable", "name points that lie apart"};
  }

  HeadTurn last;
  for (const TrackFrame& frame : track.frames) {
    const bool usable = seen(frame);
    if (usable && !places.empty()) {
      fit.seen.clear();
      for (const std::size_t i : stable) fit.seen.push_back(frame.points[i]);
      if (fitted) {
        last = find_turn(fit, extent);
      } else {
        last.shift = fit.seen[0] - fit.pivot;
      }
    }
    still.turns.push_back(last);
    still.confidence.push_back(usable ? std::min(frame.confidence, 1.0) : 0.0);
    auto& offsets = still.offsets.emplace_back();
    for (std::size_t i = 0; usable && i < track.point_count; ++i) {
      const glm::dvec3 y = last.rotation * neutral_place(i) * last.scale;
      const PxPoint expected = PxPoint{y.x, y.y} + still.pivot + last.shift;
      offsets.push_back(turned_back(last, frame.points[i] - expected));
    }
  }
  return still;
}

}  // namespace penpose::animation
