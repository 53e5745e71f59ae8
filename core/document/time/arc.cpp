#include "core/document/time/arc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/algebra/cholesky.h"
#include "core/curve/polyline.h"
#include "core/document/time/key_fit.h"
#include "core/document/time/timeline_editing.h"

namespace penpose::document {
namespace {

constexpr double k_tolerance_px = 0.7;
/// What a control costs that does not move in these moments, beside one that does.
constexpr double k_other_cost = 30;
/// A difference of a control, as a share of its range.
constexpr double k_step_share = 1e-4;
constexpr double k_least_change_share = 1e-5;
/// px of a control's whole range: less is nothing.
constexpr double k_least_effect_px = 0.05;
constexpr int k_rounds = 6;

/// The solver stops adding controls once the rest of the way is below this share of it, or below this many px.
constexpr double k_enough_share = 0.15, k_enough_px = 2;

/// The solver adds at most this many resting shapes, one at a time, before it takes all of them.
constexpr int k_most_added = 4;

/// Which controls are used: the next ones only where these are not enough.
enum class Tier : std::uint8_t {
  moving,  ///< those that move in these moments anyway
  shapes,  ///< and shapes and sketched controls
  all,     ///< and joints
};

/// A control that may move, in shares of its range.
struct FreeControl {
  std::size_t parameter = 0;
  double range = 1;
  double cost = 1;
  Tier tier = Tier::moving;
};

/// `starts`: the poses of all frames.
std::vector<FreeControl> free_controls(const Document& document, const ArcView& view,
                                       std::span<const rig::Pose> starts) {
  const auto parameters = document.model->rig->parameters();
  std::vector<FreeControl> free;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double range = parameters[i].maximum - parameters[i].minimum;
    const bool locked =
        std::find(document.locked.begin(), document.locked.end(), parameters[i].name) != document.locked.end();
    if (!view.moves(i) || locked || !(range > 0)) continue;
    const bool varies = std::any_of(starts.begin(), starts.end(), [&](const rig::Pose& pose) {
      return std::abs(pose[i] - starts.front()[i]) > k_least_change_share * range;
    });
    const Tier tier = varies ? Tier::moving : i < weight_count(*document.model) ? Tier::shapes : Tier::all;
    free.push_back({i, range, varies ? 1 : k_other_cost, tier});
  }
  return free;
}

/// One frame: the least change of the pose, by what it costs, that brings the point to its place.
class FrameSolver {
 public:
  FrameSolver(const Document& document, const ArcView& view, std::vector<FreeControl> free)
      : parameters_(document.model->rig->parameters()), view_(view), free_(std::move(free)) {}

  [[nodiscard]] const std::vector<FreeControl>& free() const { return free_; }
  void add(const FreeControl& control) { free_.push_back(control); }
  [[nodiscard]] bool uses(const FreeControl& control) const {
    return std::any_of(free_.begin(), free_.end(),
                       [&](const FreeControl& one) { return one.parameter == control.parameter; });
  }
  /// How far the point would be from its place where a control alone went on from a pose, px.
  [[nodiscard]] double left_by(const FreeControl& control, const rig::Pose& pose, const PxPoint& target) const {
    const auto now = view_.at(pose);
    if (!now) return 1e300;
    const PxPoint effect = effect_of(control, pose, *now);
    const PxPoint away = target - *now;
    const double square = geometry::dot(effect, effect);
    if (!(square > 0)) return 1e300;
    const rig::Parameter& range = parameters_[control.parameter];
    const double value = pose[control.parameter];
    const double share = std::clamp(geometry::dot(effect, away) / square, (range.minimum - value) / control.range,
                                    (range.maximum - value) / control.range);
    return geometry::distance(effect * share, away);
  }
  /// Errors: the point is behind the eye.
  base::Status solve(rig::Pose& pose, const PxPoint& target) const {
    const rig::Pose start = pose;
    for (int round = 0; round < k_rounds; ++round) {
      const auto now = view_.at(pose);
      if (!now) return base::Error{"the point is behind the eye", "view", "turn the view"};
      const PxPoint away = target - *now;
      if (geometry::dot(away, away) < 1e-4) break;
      if (!step(start, pose, *now, away)) break;
    }
    return base::Done{};
  }

 private:
  /// A Gauss-Newton step; false where nothing moves the point.
  bool step(const rig::Pose& start, rig::Pose& pose, const PxPoint& now, const PxPoint& away) const {
    std::vector<PxPoint> effects(free_.size());
    std::vector<bool> held(free_.size(), false);
    rig::Pose ends;  // with the controls that are held
    PxPoint wanted = away;
    bool any = false;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      effects[k] = effect_of(free_[k], pose, now);
      any = any || geometry::dot(effects[k], effects[k]) > k_least_effect_px * k_least_effect_px;
      // The change is reckoned from the start, of which the least is wanted.
      wanted = wanted + effects[k] * ((pose[free_[k].parameter] - start[free_[k].parameter]) / free_[k].range);
    }
    if (!any) return false;
    // Controls that would leave their ranges are held at their ends, and the others found anew.
    for (std::size_t holds = 0; holds <= free_.size(); ++holds) {
      const auto shift = multiplier(effects, held, start, ends, wanted);
      bool held_more = false;
      for (std::size_t k = 0; k < free_.size(); ++k) {
        if (held[k]) continue;
        const std::size_t p = free_[k].parameter;
        const double share = (effects[k].x * shift.x + effects[k].y * shift.y) / free_[k].cost;
        const double value = start[p] + share * free_[k].range;
        pose[p] = std::clamp(value, parameters_[p].minimum, parameters_[p].maximum);
        if (pose[p] != value) held[k] = held_more = true;
      }
      if (!held_more) break;
      ends = pose;
    }
    return true;
  }

  PxPoint effect_of(const FreeControl& control, const rig::Pose& pose, const PxPoint& now) const {
    const std::size_t p = control.parameter;
    rig::Pose other = pose;
    const bool up = pose[p] + k_step_share * control.range <= parameters_[p].maximum;
    other[p] += (up ? k_step_share : -k_step_share) * control.range;
    const auto there = view_.at(other);
    return there ? (*there - now) * (1 / (up ? k_step_share : -k_step_share)) : PxPoint{0, 0};
  }

  /// y of (J W^-1 J') y = what is left of the way.
  PxPoint multiplier(std::span<const PxPoint> effects, const std::vector<bool>& held, const rig::Pose& start,
                     const rig::Pose& ends, const PxPoint& wanted) const {
    std::array<double, 4> matrix{};
    PxPoint left = wanted;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const PxPoint& e = effects[k];
      if (held[k]) {
        left = left - e * ((ends[free_[k].parameter] - start[free_[k].parameter]) / free_[k].range);
        continue;
      }
      matrix[0] += e.x * e.x / free_[k].cost;
      matrix[2] += e.y * e.x / free_[k].cost;
      matrix[3] += e.y * e.y / free_[k].cost;
    }
    // Across the way that the controls know, the point stays off its place: nothing blows up.
    const double ridge = 1e-4 * (matrix[0] + matrix[3]) + 1e-12;
    matrix[0] += ridge;
    matrix[3] += ridge;
    std::array<double, 2> y{left.x, left.y};
    if (!algebra::factor(matrix.data(), 2)) return {0, 0};
    algebra::solve_factored(matrix.data(), 2, y.data());
    return {y[0], y[1]};
  }

  std::span<const rig::Parameter> parameters_;
  const ArcView& view_;
  std::vector<FreeControl> free_;
};

/// The controls up to a tier.
std::vector<FreeControl> up_to(std::vector<FreeControl> free, Tier tier) {
  std::erase_if(free, [&](const FreeControl& one) { return one.tier > tier; });
  return free;
}

/// How far the point is from its places, px at most.
double farthest(const ArcView& view, std::span<const rig::Pose> poses, std::span<const PxPoint> places) {
  double most = 0;
  for (std::size_t f = 0; f < poses.size(); ++f) {
    if (const auto at = view.at(poses[f])) most = std::max(most, geometry::distance(*at, places[f]));
  }
  return most;
}

/// Returns the unused shape that alone brings the frames nearest to their places; nothing if no shape is left.
std::optional<FreeControl> best_shape(const FrameSolver& solver, std::span<const FreeControl> free,
                                      std::span<const rig::Pose> poses, std::span<const PxPoint> places) {
  std::optional<FreeControl> best;
  double least = 1e300;
  for (const FreeControl& one : free) {
    if (one.tier != Tier::shapes || solver.uses(one)) continue;
    double left = 0;
    for (std::size_t f = 0; f < poses.size(); ++f) left += solver.left_by(one, poses[f], places[f]);
    if (!(left < least)) continue;
    least = left;
    best = one;
  }
  return best;
}

/// The timeline with the keys of a fit.
Timeline keyed(const Document& document, const KeyFit& fit, std::span<const double> moments,
               std::span<const std::size_t> changed) {
  const auto parameters = document.model->rig->parameters();
  TimelineEditing keys(*document.timeline, parameters, document.pose);
  for (std::size_t c = 0; c < changed.size(); ++c) {
    keys.open_span(changed[c], moments.front(), moments.back());
    const rig::Parameter& range = parameters[changed[c]];
    for (const std::size_t k : fit.keys()) {
      const auto [value, slope] = fit.at(c, k);
      keys.bend(moments[k], changed[c], std::clamp(value, range.minimum, range.maximum), slope, k > 0,
                k + 1 < moments.size());
    }
  }
  return std::move(keys).finish();
}

}  // namespace

ArcView::ArcView(const Document& document, const posing::CurvePoint& point, const geometry::Camera& camera)
    : point_(point), camera_(camera), bound_(document.model->rig->bind(point.vertex)) {}

std::optional<PxPoint> ArcView::at(std::span<const double> pose) const {
  std::array<geometry::ModelPoint, 3> corners;
  bound_->evaluate(pose, corners);
  geometry::ModelPoint place{0};
  for (std::size_t i = 0; i < 3; ++i) place += corners[i] * point_.weight[i];
  return camera_.project(place);
}

std::vector<rig::Pose> poses_of_timeline(const Document& document, std::span<const double> moments_s) {
  std::vector<rig::Pose> poses;
  for (const double time_s : moments_s) poses.push_back(pose_at(document, time_s));
  return poses;
}

std::vector<PxPoint> arc_of(const Document& document, const posing::CurvePoint& point, const geometry::Camera& camera,
                            std::span<const rig::Pose> poses) {
  const ArcView view(document, point, camera);
  std::vector<PxPoint> arc;
  for (const rig::Pose& pose : poses) {
    const auto at = view.at(pose);
    arc.push_back(at ? *at : arc.empty() ? PxPoint{0, 0} : arc.back());
  }
  return arc;
}

ArcTarget target_along(std::span<const PxPoint> line, std::span<const double> shares, std::span<const double> moments_s,
                       std::span<const PxPoint> now) {
  ArcTarget target{{moments_s.begin(), moments_s.end()}, {}};
  const std::vector<double> lengths = curve::cumulative_length(line);
  const std::vector<double> passed = curve::cumulative_length(now);
  const auto along = [&](double share) {
    if (!(lengths.back() > 0)) return line.front();
    const curve::PolylinePlace place = curve::place_at(lengths, std::clamp(share, 0.0, 1.0));
    return line[place.segment] + (line[place.segment + 1] - line[place.segment]) * place.fraction;
  };
  for (std::size_t f = 0; f < moments_s.size(); ++f) {
    const double share_of_time = (moments_s[f] - moments_s.front()) / (moments_s.back() - moments_s.front());
    if (shares.empty()) {
      target.points.push_back(along(passed.back() > 0 ? passed[f] / passed.back() : share_of_time));
      continue;
    }
    const auto after = std::lower_bound(shares.begin(), shares.end(), share_of_time);
    if (after == shares.begin() || after == shares.end()) {
      target.points.push_back(after == shares.begin() ? line.front() : line.back());
      continue;
    }
    const auto i = static_cast<std::size_t>(after - shares.begin());
    const double span = shares[i] - shares[i - 1];
    const double u = span > 0 ? (share_of_time - shares[i - 1]) / span : 1;
    target.points.push_back(line[i - 1] + (line[i] - line[i - 1]) * u);
  }
  return target;
}

base::Result<Timeline> with_arc(const Document& document, const posing::CurvePoint& point,
                                const geometry::Camera& camera, const ArcTarget& target) {
  const ArcView view(document, point, camera);
  const std::span<const double> moments = target.moments_s;
  const std::vector<rig::Pose> starts = poses_of_timeline(document, moments);
  const std::vector<FreeControl> free = free_controls(document, view, starts);
  if (free.empty()) return base::Error{"no control that is free moves this point", "point", "unlock one"};
  const double enough = std::max(k_enough_px, k_enough_share * farthest(view, starts, target.points));
  std::vector<rig::Pose> poses = starts;
  const auto solve = [&](const FrameSolver& solver) -> base::Result<bool> {
    if (solver.free().empty()) return false;
    poses = starts;
    for (std::size_t f = 0; f < moments.size(); ++f) {
      if (const auto solved = solver.solve(poses[f], target.points[f]); !solved) return solved.error();
    }
    return farthest(view, poses, target.points) <= enough;
  };
  FrameSolver few(document, view, up_to(free, Tier::moving));
  auto done = solve(few);
  for (int added = 0; done && !*done && added < k_most_added; ++added) {
    const auto next = best_shape(few, free, poses, target.points);
    if (!next) break;
    few.add(*next);
    done = solve(few);
  }
  for (const Tier tier : {Tier::shapes, Tier::all}) {
    if (done && !*done) done = solve(FrameSolver(document, view, up_to(free, tier)));
  }
  if (!done) return done.error();
  std::vector<std::size_t> changed;
  for (const FreeControl& control : free) {
    bool any = false;
    for (std::size_t f = 0; f < moments.size() && !any; ++f)
      any = std::abs(poses[f][control.parameter] - starts[f][control.parameter]) > k_least_change_share * control.range;
    if (any) changed.push_back(control.parameter);
  }
  if (changed.empty()) return *document.timeline;
  KeyFit fit(moments, poses, changed);
  Timeline timeline;
  // Ranges cut slopes: what the timeline makes of the fit is what counts.
  fit.refine(k_tolerance_px, [&] {
    timeline = keyed(document, fit, moments, changed);
    std::vector<double> off;
    for (std::size_t f = 0; f < moments.size(); ++f) {
      const auto at = view.at(sample(timeline, moments[f], document.pose));
      const auto meant = view.at(poses[f]);
      off.push_back(at && meant ? geometry::distance(*at, *meant) : 0);
    }
    return off;
  });
  return timeline;
}

}  // namespace penpose::document
