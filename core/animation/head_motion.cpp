#include "core/animation/head_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/math.h"
#include "core/base/numbers.h"
#include "core/geometry/rotation.h"

namespace penpose::animation {
namespace {

/// Stable points of the neutral frame about their middle, and where they are in another frame.
struct Fit {
  std::vector<glm::dvec3> shape;
  std::vector<PxPoint> seen;
  PxPoint pivot;
  double nearness = 0;  ///< how much a point grows with each px that it is nearer to the camera; 0: seen from afar
};

/// Where a point of the neutral shape is seen, about the pivot and the shift, and its depth.
struct Seen {
  PxPoint place;
  double growth = 1;
};
Seen see(const Fit& fit, const HeadTurn& turn, const glm::dvec3& x) {
  const glm::dvec3 y = turn.rotation * x;
  const double growth = turn.scale / std::max(0.1, 1.0 + fit.nearness * y.z);
  return {{y.x * growth, y.y * growth}, growth};
}

PxPoint middle(std::span<const PxPoint> points) {
  PxPoint sum;
  for (const PxPoint& p : points) sum = sum + p;
  return sum * (1.0 / static_cast<double>(points.size()));
}

/// The shape as a head that is turned so shows it, before scale, roll and shift.
std::vector<PxPoint> shown(const Fit& fit, const glm::dmat3& rotation) {
  HeadTurn turn;
  turn.rotation = rotation;
  std::vector<PxPoint> places;
  for (const glm::dvec3& x : fit.shape) places.push_back(see(fit, turn, x).place);
  return places;
}

/// The similarity of least squares in closed form, after a turn that is given: with points as complex numbers about
/// their middles, the factor is sum(conj(x) p) / sum(|x|^2).
HeadTurn similarity(const Fit& fit, const glm::dmat3& rotation) {
  const auto places = shown(fit, rotation);
  const PxPoint middle_shown = middle(places);
  const PxPoint middle_seen = middle(fit.seen);
  double real = 0;
  double imaginary = 0;
  double square = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PxPoint x = places[i] - middle_shown;
    const PxPoint p = fit.seen[i] - middle_seen;
    real += x.x * p.x + x.y * p.y;
    imaginary += x.x * p.y - x.y * p.x;
    square += x.x * x.x + x.y * x.y;
  }
  HeadTurn turn;
  turn.rotation = rotation;
  const double size = std::sqrt(real * real + imaginary * imaginary);
  if (!(size > 1e-12 * square)) {
    turn.shift = middle_seen - fit.pivot - middle_shown;
    return turn;
  }
  turn.scale = size / square;
  const double c = real / size;
  const double s = imaginary / size;
  turn.rotation = glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * rotation;
  const PxPoint moved = {c * middle_shown.x - s * middle_shown.y, s * middle_shown.x + c * middle_shown.y};
  turn.shift = middle_seen - fit.pivot - moved * turn.scale;
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
    const Seen at = see(fit, turn, fit.shape[i]);
    const glm::dvec3 y = turn.rotation * fit.shape[i] * at.growth;  // the growth's own slope is left to the next step
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
    const PxPoint left = fit.seen[i] - fit.pivot - turn.shift - see(fit, turn, fit.shape[i]).place;
    sum += left.x * left.x + left.y * left.y;
  }
  return std::sqrt(sum / static_cast<double>(fit.shape.size()));
}

/// How the head is turned, by all points that tell of it. Gauss-Newton from the similarity; a head that would face away
/// is none that a tracker sees, then the similarity stands.
glm::dmat3 find_rotation(const Fit& turning) {
  HeadTurn turn = similarity(turning, glm::dmat3(1));
  const glm::dmat3 flat = turn.rotation;
  const double extent = extent_of(turning);
  constexpr int k_steps = 25;
  for (int i = 0; i < k_steps && refine(turning, extent, turn); ++i) {
  }
  return turn.rotation[2][2] > 0.3 ? turn.rotation : flat;
}

/// The offset from the neutral place that, on a head standing like that, is seen as `apart`.
PxPoint turned_back(const HeadTurn& turn, double growth, PxPoint apart) {
  const auto& r = turn.rotation;
  const double inverse = 1.0 / (growth * (r[0][0] * r[1][1] - r[1][0] * r[0][1]));
  return {(r[1][1] * apart.x - r[1][0] * apart.y) * inverse, (r[0][0] * apart.y - r[0][1] * apart.x) * inverse};
}

/// The neutral face as a shape in space, and the fits of a frame to it.
class HeadShape {
 public:
  HeadShape(const TrackFrame& neutral, std::span<const std::size_t> stable, std::span<const std::size_t> turning)
      : neutral_(neutral), stable_(stable.begin(), stable.end()), turning_(stable_) {
    for (const std::size_t i : turning) {
      if (std::find(turning_.begin(), turning_.end(), i) == turning_.end()) turning_.push_back(i);
    }
    std::vector<PxPoint> places;
    for (const std::size_t i : stable_) places.push_back(neutral.points[i]);
    if (!places.empty()) pivot_ = middle(places);
    solid_ = stable_.size() >= 3 && turning_.size() >= 4 && !neutral.depths.empty();
    for (const std::size_t i : stable_) {
      if (solid_) depth_ += neutral.depths[i] / static_cast<double>(stable_.size());
    }
    set_nearness(0);
  }

  [[nodiscard]] PxPoint pivot() const { return pivot_; }
  [[nodiscard]] bool solid() const { return solid_; }
  [[nodiscard]] double extent() const { return stable_.size() < 2 ? 1.0 : extent_of(fit_); }

  void set_nearness(double nearness) {
    fit_ = shape_of(stable_, nearness);
    broad_ = shape_of(turning_, nearness);
  }

  HeadTurn turn_of(const TrackFrame& frame) {
    look(frame, stable_, fit_);
    HeadTurn turn;
    if (stable_.size() < 2) {
      if (!stable_.empty()) turn.shift = fit_.seen[0] - fit_.pivot;
      return turn;
    }
    glm::dmat3 rotation(1);
    if (solid_) {
      look(frame, turning_, broad_);
      rotation = find_rotation(broad_);
    }
    turn = similarity(fit_, rotation);
    turn.residual_px = residual(fit_, turn);
    return turn;
  }

  /// What the frame shows beyond the neutral face on that head.
  [[nodiscard]] std::vector<PxPoint> offsets(const TrackFrame& frame, const HeadTurn& turn) const {
    std::vector<PxPoint> all;
    for (std::size_t i = 0; i < frame.points.size(); ++i) {
      const glm::dvec3 x = place(i, fit_.nearness);
      const Seen seen = see(fit_, turn, x);
      const PxPoint apart = frame.points[i] - pivot_ - turn.shift - seen.place;
      const double own = std::max(0.1, 1.0 + fit_.nearness * x.z);
      all.push_back(turned_back(turn, seen.growth * own, apart));
    }
    return all;
  }

 private:
  /// A point of the neutral face about the pivot, in space.
  [[nodiscard]] glm::dvec3 place(std::size_t i, double nearness) const {
    const double z = solid_ ? depth_ - neutral_.depths[i] : 0.0;
    const PxPoint p = (neutral_.points[i] - pivot_) * std::max(0.1, 1.0 + nearness * z);
    return {p.x, p.y, z};
  }
  [[nodiscard]] Fit shape_of(const std::vector<std::size_t>& points, double nearness) const {
    Fit fit;
    fit.pivot = pivot_;
    fit.nearness = nearness;
    for (const std::size_t i : points) fit.shape.push_back(place(i, nearness));
    return fit;
  }
  static void look(const TrackFrame& frame, const std::vector<std::size_t>& points, Fit& fit) {
    fit.seen.clear();
    for (const std::size_t i : points) fit.seen.push_back(frame.points[i]);
  }

  const TrackFrame& neutral_;
  std::vector<std::size_t> stable_;
  std::vector<std::size_t> turning_;  ///< the stable points and those that only tell of the turn
  PxPoint pivot_;
  bool solid_ = false;
  double depth_ = 0;  ///< mean of the stable points
  Fit fit_;
  Fit broad_;
};

double doubt_of(const HeadTurn& turn, double extent) {
  const double angle = base::acos(turn.rotation[2][2]) / 0.2;
  const double left = turn.residual_px / (0.03 * extent * turn.scale);
  const double doubt = angle * angle + left * left;
  return doubt / (1.0 + doubt);
}

/// Whether the points can be those of the neutral frame's head at all. Trackers that lose a face put the points
/// anywhere for a frame or two and may be sure of it.
bool is_head(const HeadTurn& turn, double extent) {
  constexpr double k_most = 0.5;  // of the stable points' own extent; a head that turns away leaves a fifth of that
  return turn.residual_px <= k_most * extent * turn.scale;
}

/// How near the camera was, from what fits the stable points best over the clip: a face that fills the picture of a
/// phone is seen with strong perspective, one in a film with none. In 1/px; 0 unless it explains a good deal.
double find_nearness(HeadShape& shape, std::span<const TrackFrame* const> frames) {
  constexpr std::size_t k_most_frames = 100;
  const std::size_t stride = frames.size() / k_most_frames + 1;
  double best = 0;
  double least = 0;
  for (int k = 0; k <= 6; ++k) {
    const double nearness = 0.04 * k / shape.extent();
    shape.set_nearness(nearness);
    double sum = 0;
    for (std::size_t f = 0; f < frames.size(); f += stride) {
      const double left = shape.turn_of(*frames[f]).residual_px;
      sum += left * left;
    }
    if (k == 0 || sum < 0.95 * least) {
      best = nearness;
      least = sum;
    }
  }
  return best;
}

/// px; stable points nearer to each other than this tell of no turn.
constexpr double k_least_extent = 1e-9;

}  // namespace

base::Result<StillTrack> take_head_motion_out(const PointTrack& track, const StablePoints& points,
                                              std::optional<std::size_t> neutral, double least_confidence) {
  const auto seen = [&](const TrackFrame& frame) { return frame.found() && frame.confidence >= least_confidence; };
  for (const auto* list : {&points.stable, &points.turning}) {
    for (const std::size_t i : *list) {
      if (i < track.point_count) continue;
      return base::Error{"point " + std::to_string(i) + " does not exist; the track has " +
                             std::to_string(track.point_count) + " points",
                         list == &points.stable ? "/stable" : "/turning", "use a map for this format"};
    }
  }
  StillTrack still;
  if (neutral) {
    if (*neutral >= track.frames.size() || !seen(track.frames[*neutral])) {
      return base::Error{"frame " + std::to_string(*neutral) + " shows no face to start from", "",
                         "choose another neutral frame"};
    }
    still.neutral = *neutral;
  } else {
    const auto first = std::find_if(track.frames.begin(), track.frames.end(), seen);
    if (first == track.frames.end()) {
      const bool any = std::any_of(track.frames.begin(), track.frames.end(), [](const auto& f) { return f.found(); });
      if (any) {
        return base::Error{"no frame is as sure of its face as " + base::format_fixed(least_confidence, 2), "",
                           "track the video again, or ask for less with --confidence"};
      }
      return base::Error{"no frame shows a face", "", "track the video again"};
    }
    // A tracker that has lost the face may put all its points at one place.
    const auto lies_apart = [&](const TrackFrame& frame) {
      return seen(frame) && HeadShape(frame, points.stable, points.turning).extent() > k_least_extent;
    };
    const auto apart = std::find_if(first, track.frames.end(), lies_apart);
    still.neutral = static_cast<std::size_t>((apart == track.frames.end() ? first : apart) - track.frames.begin());
  }
  HeadShape shape(track.frames[still.neutral], points.stable, points.turning);
  if (!(shape.extent() > k_least_extent)) {
    return base::Error{"all stable points are at one place", "/stable", "name points that lie apart"};
  }
  still.pivot = shape.pivot();
  std::vector<const TrackFrame*> usable;
  for (const TrackFrame& frame : track.frames) {
    if (seen(frame)) usable.push_back(&frame);
  }
  if (shape.solid()) shape.set_nearness(find_nearness(shape, usable));

  HeadTurn last;
  for (const TrackFrame& frame : track.frames) {
    bool here = seen(frame);
    if (here) {
      const HeadTurn turn = shape.turn_of(frame);
      here = is_head(turn, shape.extent());
      if (here) last = turn;
    }
    still.turns.push_back(last);
    still.doubt.push_back(doubt_of(last, shape.extent()));
    still.confidence.push_back(here ? std::min(frame.confidence, 1.0) : 0.0);
    still.offsets.push_back(here ? shape.offsets(frame, last) : std::vector<PxPoint>());
  }
  return still;
}

}  // namespace penpose::animation
