#include "core/articulation/measured_deformer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/articulation/measure/relaxation.h"
#include "core/articulation/motion/attachment.h"
#include "core/articulation/motion/slide.h"
#include "core/curve/polyline.h"

namespace penpose::articulation {
namespace {

/// A rotation has to distort this much less than a translation to be chosen.
constexpr double k_measurably = 0.9;
/// Shares of the range at which motions are measured.
constexpr std::array<double, 3> k_amounts{0.35, 0.7, 1.0};
/// And between those, where a turn may fold what neither end of it folds.
constexpr std::array<double, 4> k_between_amounts{0.2, 0.5, 0.6, 0.85};
/// Shares of the way from the border of the region of specific interest to the curve that the falloff may take, tried
/// in turn.
constexpr std::array<double, 3> k_depths{0.0, 0.4, 0.8};
/// An edge may be stretched by this times the ratio of the target's length to the reference's.
constexpr double k_bound = 1.95;
/// Above which what was given way to is still right, times that: 2, but for rounding.
constexpr double k_held = 1.999 / 1.95;

/// The influence of the whole curve on every node, without weights.
struct CurveInfluence {
  std::vector<double> places;
  std::vector<double> distances;
  std::vector<ModelVector> moves;
  std::vector<ModelVector> turns;
  std::vector<ModelVector> slides;  ///< over a ball: turns, and the tilts after them
  std::vector<ModelVector> tilts;
};

CurveInfluence influence_of(const MeasuredParts& parts, const Swing* swing, const Slide* slide) {
  CurveInfluence influence;
  const std::size_t n = parts.patch.inner_count();
  influence.places.resize(n);
  influence.distances.assign(parts.patch.node_count(), 0.0);
  influence.moves.resize(n);
  if (swing != nullptr) influence.turns.resize(n);
  std::vector<ModelVector> ways;
  for (std::size_t i = 0; i < parts.reference.size(); ++i) ways.push_back(parts.target[i] - parts.reference[i]);
  Attachment attachment(parts.reference);
  for (std::size_t node = 0; node < n; ++node) {
    attachment.attach(parts.patch.rests()[node]);
    influence.places[node] = attachment.place();
    influence.distances[node] = attachment.distance();
    influence.moves[node] = attachment.mean_of_points(ways);
    if (slide != nullptr) {
      influence.slides.push_back(attachment.mean_of_points(slide->turns()));
      influence.tilts.push_back(attachment.mean_of_points(slide->tilts()));
    }
    if (swing != nullptr) influence.turns[node] = attachment.mean_of_segments(swing->turns());
  }
  return influence;
}

/// A motion of all inner nodes, measured.
struct Outcome {
  std::shared_ptr<const CurveMotion> motion;
  std::vector<BlendedBinding> bindings;  ///< one an inner node
  Strain strain;
  bool looked = false;  ///< between the amounts
};

/// How motions are told apart: what tears nothing comes first, then what stretches nothing beyond the bound, then what
/// distorts least.
struct Judge {
  double bound = 2;

  [[nodiscard]] bool passes(const Strain& strain) const {
    return strain.turned_over + strain.creased == 0 && strain.stretch <= bound;
  }
  /// The bound itself, which is a little more than what is aimed at.
  [[nodiscard]] bool holds(const Strain& strain) const {
    return strain.turned_over + strain.creased == 0 && strain.stretch <= k_held * bound;
  }
  [[nodiscard]] bool better(const Strain& a, const Strain& b, double factor) const {
    const std::size_t torn_a = a.turned_over + a.creased;
    const std::size_t torn_b = b.turned_over + b.creased;
    if (torn_a != torn_b) return torn_a < torn_b;
    const double excess_a = std::max(a.stretch, bound);
    const double excess_b = std::max(b.stretch, bound);
    if (excess_a != excess_b) return excess_a < excess_b;
    return a.energy < factor * b.energy;
  }
};

class Trial {
 public:
  Trial(const MeasuredParts& parts, const CurveInfluence& influence, Range range)
      : parts_(parts),
        influence_(influence),
        range_(range),
        length_(curve::arc_length<ModelPoint>(parts.reference)),
        meter_(parts.patch),
        moves_(parts.patch.node_count()) {}

  [[nodiscard]] Outcome attempt(const std::shared_ptr<const CurveMotion>& motion, std::span<const double> weights) {
    Outcome outcome{motion, {}, {}};
    const auto last = static_cast<double>(motion->segment_count() - 1);
    outcome.bindings.reserve(parts_.patch.inner_count());
    for (std::size_t node = 0; node < parts_.patch.inner_count(); ++node) {
      BlendedBinding binding;
      const double segment = std::min(std::floor(influence_.places[node]), last);
      binding.segment = static_cast<std::uint32_t>(segment);
      binding.fraction = influence_.places[node] - segment;
      binding.weight = weights[node];
      binding.rest = parts_.patch.rests()[node];
      binding.move = influence_.moves[node] * weights[node];
      if (motion->swing() != nullptr) binding.turn = influence_.turns[node] * weights[node];
      if (motion->slide() != nullptr) {
        binding.turn = influence_.slides[node] * weights[node];
        binding.move = influence_.tilts[node] * weights[node];
      }
      outcome.bindings.push_back(binding);
    }
    measure(outcome);
    return outcome;
  }

  /// Measures what passes between the amounts too. What it costs in energy is known well enough.
  void look_between(Outcome& outcome, const Judge& judge) {
    if (outcome.looked || !judge.holds(outcome.strain)) return;
    outcome.looked = true;
    const CurveSkin skin(outcome.motion, parts_.surface, outcome.bindings, false);
    const double energy = outcome.strain.energy;
    if (range_.minimum < 0.0) outcome.strain = worse(outcome.strain, at(skin, 0.5 * range_.minimum));
    for (const double share : k_between_amounts) {
      outcome.strain = worse(outcome.strain, at(skin, share * range_.maximum));
    }
    outcome.strain.energy = energy;
  }

  /// Gives way where the surface is torn or stretched beyond the bound at either end of the range (relaxation.h): what
  /// is near the curve hardly, what lies on it not at all. What came nearest to passing is kept.
  void hold(Outcome& outcome, const Judge& judge) {
    Outcome held = outcome;
    hold_at(range_.maximum, held, judge);
    if (range_.minimum < 0.0) hold_at(range_.minimum, held, judge);
    measure(held);
    if (judge.better(held.strain, outcome.strain, 1.0)) outcome = std::move(held);
  }

 private:
  static constexpr double k_near = 0.025;
  static constexpr double k_leash = 0.02;  ///< in lengths of the curve, on it; longer by as much as a node is beside it
  static constexpr double k_safe = 0.97;   ///< other amounts stretch a little more
  static constexpr int k_hold_rounds = 20;
  static constexpr int k_unfold_sweeps = 12;
  static constexpr int k_limit_sweeps = 10;

  Strain at(const CurveSkin& skin, double amount) {
    skin.displacements(amount, work_, std::span(moves_).first(skin.size()));
    return meter_.measure(moves_);
  }

  void measure(Outcome& outcome) {
    const CurveSkin skin(outcome.motion, parts_.surface, outcome.bindings, false);
    outcome.looked = false;
    outcome.strain = {};
    if (range_.minimum < 0.0) outcome.strain = at(skin, range_.minimum);
    for (const double share : k_amounts) outcome.strain = worse(outcome.strain, at(skin, share * range_.maximum));
  }

  void hold_at(double amount, Outcome& held, const Judge& judge) {
    const std::size_t n = parts_.patch.inner_count();
    if (!relaxation_) {
      const double near = k_near * length_;
      std::vector<double> give(n);
      for (std::size_t node = 0; node < n; ++node) {
        const double square = influence_.distances[node] * influence_.distances[node];
        give[node] = square > 1e-12 * length_ * length_ ? square / (square + near * near) : 0.0;
      }
      relaxation_.emplace(parts_.patch, std::move(give));
    }
    Strain strain = at(CurveSkin(held.motion, parts_.surface, held.bindings, false), amount);
    if (judge.passes(strain)) return;
    const std::vector<ModelVector> before(moves_.begin(), moves_.begin() + static_cast<std::ptrdiff_t>(n));
    std::vector<ModelVector> best = before;
    Strain nearest = strain;
    std::vector<ModelPoint> places(parts_.patch.rests().begin(), parts_.patch.rests().end());
    for (std::size_t node = 0; node < n; ++node) places[node] += moves_[node];
    std::vector<std::uint8_t> marked(places.size(), 0);
    std::vector<std::uint8_t> stiff;
    for (int round = 0; round < k_hold_rounds && !judge.passes(nearest); ++round) {
      if (strain.turned_over + strain.creased > 0) {
        std::fill(marked.begin(), marked.end(), 0);
        meter_.mark_torn(marked);
        grow(marked);
        stiff = marked;
        grow(marked, 1 + round / 2);
        relaxation_->unfold(stiff, marked, k_unfold_sweeps, places);
      }
      if (strain.stretch > judge.bound) relaxation_->limit_stretch(k_safe * judge.bound, k_limit_sweeps, places);
      if (held.motion->slide() != nullptr) keep_sliding(held.motion->slide()->axis(), before, places);
      for (std::size_t node = 0; node < n; ++node) moves_[node] = places[node] - parts_.patch.rests()[node];
      strain = meter_.measure(moves_);
      if (!judge.better(strain, nearest, 1.0)) continue;
      nearest = strain;
      best.assign(moves_.begin(), moves_.begin() + static_cast<std::ptrdiff_t>(n));
    }
    for (std::size_t node = 0; node < n; ++node) {
      BlendedBinding& own = held.bindings[node];
      if (best[node] == before[node]) continue;
      const ModelVector more = (best[node] - before[node]) / amount;
      if (amount < 0.0) {
        own.less = more;
      } else if (held.motion->swing() != nullptr || held.motion->slide() != nullptr || range_.minimum < 0.0) {
        own.more = more;
      } else {
        own.move = best[node] / amount;
      }
    }
  }

  /// Along the axis of a slide every node stays where the slide brings it: that is the width of its row. On a ball that
  /// was found, places that gave way come back onto it, and what lies on the curve stays within a leash of where it was
  /// drawn.
  void keep_sliding(const ModelVector& axis, std::span<const ModelVector> before, std::span<ModelPoint> places) const {
    for (std::size_t node = 0; node < before.size(); ++node) {
      const ModelPoint& rest = parts_.patch.rests()[node];
      places[node] -= axis * glm::dot(axis, places[node] - rest - before[node]);
      if (!parts_.found) continue;
      ModelVector way = places[node] - rest - before[node];
      const double most = k_leash * length_ + influence_.distances[node];
      const double size = geometry::length(way);
      if (size > most) way *= most / size;
      places[node] = parts_.surface.keep(rest + before[node] + way, rest, parts_.surface.level(rest));
    }
  }

  /// Marks what lies about the marked nodes too, `rings` times.
  void grow(std::vector<std::uint8_t>& marked, int rings = 1) const {
    std::vector<std::uint32_t> last;
    for (std::uint32_t node = 0; node < marked.size(); ++node) {
      if (marked[node] != 0) last.push_back(node);
    }
    for (std::vector<std::uint32_t> next; rings > 0; --rings, last.swap(next), next.clear()) {
      for (const std::uint32_t node : last) {
        for (const std::uint32_t t : parts_.patch.star(node)) {
          for (const std::uint32_t other : parts_.patch.triangles()[t]) {
            if (marked[other] != 0) continue;
            marked[other] = 1;
            next.push_back(other);
          }
        }
      }
    }
  }

  const MeasuredParts& parts_;
  const CurveInfluence& influence_;
  Range range_;
  double length_;  ///< of the reference
  Strainmeter meter_;
  CurveSkinWorkspace work_;
  std::vector<ModelVector> moves_;
  std::optional<Relaxation> relaxation_;
};

}  // namespace

base::Result<MeasuredMotion> measured_motion(const MeasuredParts& parts, Mode mode, Range range) {
  const auto motion_of = [&](Mode one) {
    auto motion = std::make_shared<CurveMotion>(parts.reference, parts.target, one, Turning::swung);
    const auto center = parts.surface.center();
    if (center && one == Mode::translate) {
      motion->set_slide(std::make_shared<const Slide>(*center, parts.reference, parts.target));
    }
    return std::shared_ptr<const CurveMotion>(std::move(motion));
  };
  const auto straight = mode == Mode::rotate ? nullptr : motion_of(Mode::translate);
  const bool slides = straight && straight->slide() != nullptr && mode == Mode::automatic;
  const auto swing = mode == Mode::translate || slides ? nullptr : motion_of(Mode::rotate);
  const CurveInfluence influence =
      influence_of(parts, swing ? swing->swing() : nullptr, straight ? straight->slide() : nullptr);
  const double length = curve::arc_length<ModelPoint>(parts.reference);
  const Judge judge{k_bound * std::max(1.0, curve::arc_length<ModelPoint>(parts.target) / length)};
  Trial trial(parts, influence, range);
  std::optional<Outcome> best;
  std::vector<double> inward;
  for (const double depth : k_depths) {
    if (depth > 0.0 && inward.empty()) inward = parts.falloff.inward();
    const auto weights =
        depth > 0.0 ? parts.falloff.weights(depth, inward, influence.distances) : parts.falloff.weights();
    std::vector<Outcome> tried;
    for (const auto& [motion, factor] : {std::pair{straight, 1.0}, std::pair{swing, k_measurably}}) {
      if (!motion) continue;
      auto outcome = trial.attempt(motion, weights);
      if (motion->swing() != nullptr || motion->slide() != nullptr) trial.look_between(outcome, judge);
      tried.push_back(outcome);
      if (!best || judge.better(outcome.strain, best->strain, factor)) best = std::move(outcome);
    }
    if (judge.passes(best->strain)) break;
    // What distorts less gives way first; the other way of moving only where that does not do.
    if (tried.size() == 2 && judge.better(tried[1].strain, tried[0].strain, k_measurably))
      std::swap(tried[0], tried[1]);
    for (Outcome& held : tried) {
      trial.hold(held, judge);
      trial.look_between(held, judge);
      if (judge.better(held.strain, best->strain, 1.0)) best = std::move(held);
      if (judge.holds(best->strain)) break;
    }
    if (judge.holds(best->strain)) break;
  }

  MeasuredMotion result;
  std::vector<BlendedBinding> bindings;
  for (std::size_t i = 0; i < parts.region.vertices.size(); ++i) {
    BlendedBinding binding = best->bindings[parts.patch.nodes()[i]];
    if (!(binding.weight > 0.0) && !parts.whole) continue;
    const std::uint32_t v = parts.region.vertices[i];
    auto to_rest = parts.canvas.to_rest(v);
    if (!to_rest) return to_rest.error();
    binding.to_rest = *to_rest;
    binding.rest = parts.canvas.positions()[v];
    bindings.push_back(binding);
    result.vertices.push_back(v);
    result.weights.push_back(binding.weight);
  }
  result.vertices.shrink_to_fit();
  result.weights.shrink_to_fit();
  result.strain = best->strain;
  result.strain.node = parts.patch.vertex(best->strain.node);
  result.skin = CurveSkin(best->motion, parts.surface, bindings, parts.canvas.carried());
  if (parts.whole) result.of_nodes = CurveSkin(best->motion, parts.surface, best->bindings, false);
  return result;
}

Strain strain_at(const MeasuredParts& parts, const CurveSkin& of_nodes, std::span<const double> amounts) {
  Strainmeter meter(parts.patch);
  CurveSkinWorkspace work;
  std::vector<ModelVector> moves(parts.patch.node_count());
  Strain strain;
  for (const double amount : amounts) {
    of_nodes.displacements(amount, work, std::span(moves).first(of_nodes.size()));
    strain = worse(strain, meter.measure(moves));
  }
  strain.node = parts.patch.vertex(strain.node);
  return strain;
}

}  // namespace penpose::articulation
