#include "core/animation/head/head_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/animation/head/head_fit.h"
#include "core/base/math.h"
#include "core/base/numbers.h"

namespace penpose::animation {
namespace {

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

  /// The turn that best explains the stable points, and them alone: a face that differs from the neutral one in depth
  /// is explained by some turn too, and what is then left is the expression.
  HeadTurn fit(const TrackFrame& frame) {
    look(frame, stable_, fit_);
    if (stable_.size() < 2) {
      HeadTurn turn;
      if (!stable_.empty()) turn.shift = fit_.seen[0] - fit_.pivot;
      return turn;
    }
    return at(solid_ ? rotation_of(frame, stable_.size() >= 4 ? Points::stable : Points::all) : glm::dmat3(1));
  }

  /// How the head stands: turned as the tracker says, or as far as all points tell (those that lie far behind the
  /// others know a nod from a smile that draws the nose down), at the place and of the size of the stable points.
  /// `fitted` is the fit of the same frame, which was the last.
  HeadTurn stand(const TrackFrame& frame, const HeadTurn& fitted, const std::optional<glm::dmat3>& told) {
    if (!told && (!solid_ || turning_.size() == stable_.size())) return fitted;
    HeadTurn turn = told ? similarity(fit_, *told, Roll::kept) : similarity(fit_, rotation_of(frame, Points::all));
    turn.residual_px = fitted.residual_px;
    return turn;
  }

  /// The turn of the stable points for a rotation that is given, of the frame that was fitted last.
  [[nodiscard]] HeadTurn at(const glm::dmat3& rotation) const {
    HeadTurn turn = similarity(fit_, rotation);
    turn.residual_px = residual(fit_, turn);
    return turn;
  }
  /// The turn since the neutral frame by the tracker's own account.
  [[nodiscard]] std::optional<glm::dmat3> told(const TrackFrame& frame) const {
    if (!solid_ || !frame.rotation || !neutral_.rotation) return std::nullopt;
    return *frame.rotation * glm::transpose(*neutral_.rotation);
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
  enum class Points : std::uint8_t { stable, all };

  glm::dmat3 rotation_of(const TrackFrame& frame, Points points) {
    Fit& fit = points == Points::stable ? fit_ : broad_;
    look(frame, points == Points::stable ? stable_ : turning_, fit);
    return find_rotation(fit);
  }
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
      const double left = shape.fit(*frames[f]).residual_px;
      sum += left * left;
    }
    if (k == 0 || sum < 0.95 * least) {
      best = nearness;
      least = sum;
    }
  }
  return best;
}

/// Whether the tracker's own turns are worth more than those of the fit: they are there, they are not all the same, and
/// they are turns of this head, measured in radians and about these axes.
bool tells_turns(HeadShape& shape, std::span<const TrackFrame* const> frames) {
  constexpr double k_most_apart = 0.35;  // radians, in most frames
  std::vector<double> apart;
  bool moves = false;
  for (const TrackFrame* frame : frames) {
    const auto told = shape.told(*frame);
    if (!told) continue;
    moves = moves || *told != glm::dmat3(1);
    apart.push_back(angle_of(*told * glm::transpose(shape.fit(*frame).rotation)));
  }
  if (!moves || 2 * apart.size() < frames.size()) return false;
  std::stable_sort(apart.begin(), apart.end());
  return apart[apart.size() / 2] < k_most_apart;
}

/// px; stable points nearer to each other than this tell of no turn.
constexpr double k_least_extent = 1e-9;

}  // namespace

base::Result<StillTrack> take_head_motion_out(const PointTrack& track, const StablePoints& points,
                                              std::optional<std::size_t> neutral, double least_confidence) {
  const auto seen = [&](const TrackFrame& frame) { return frame.found() && frame.confidence >= least_confidence; };
  for (const auto* list : {&points.stable, &points.turning, &points.openings}) {
    for (const std::size_t i : *list) {
      if (i < track.point_count) continue;
      return base::Error{"point " + std::to_string(i) + " does not exist; the track has " +
                             std::to_string(track.point_count) + " points",
                         list == &points.stable    ? "/stable"
                         : list == &points.turning ? "/turning"
                                                   : "/curves",
                         "use a map for this format"};
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

  const bool told = tells_turns(shape, usable);
  HeadTurn last;
  HeadTurn stand;
  for (const TrackFrame& frame : track.frames) {
    bool here = seen(frame);
    if (here) {
      const HeadTurn turn = shape.fit(frame);
      here = is_head(turn, shape.extent());
      if (here) {
        last = turn;
        stand = shape.stand(frame, turn, told ? shape.told(frame) : std::nullopt);
      }
    }
    still.turns.push_back(stand);
    still.doubt.push_back(doubt_of(last, shape.extent()));
    still.confidence.push_back(here ? std::min(frame.confidence, 1.0) : 0.0);
    still.offsets.push_back(here ? shape.offsets(frame, last) : std::vector<PxPoint>());
    if (!here || !shape.solid()) continue;
    // On a head that is turned half as far: see StablePoints.
    const auto narrow = shape.offsets(frame, shape.at(part_of(stand.rotation, 0.5)));
    for (const std::size_t i : points.openings) still.offsets.back()[i] = narrow[i];
  }
  return still;
}

}  // namespace penpose::animation
