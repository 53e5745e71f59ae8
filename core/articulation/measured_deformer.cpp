#include "core/articulation/measured_deformer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/articulation/attachment.h"

namespace penpose::articulation {
namespace {

/// A rotation has to distort this much less than a translation to be chosen.
constexpr double k_measurably = 0.9;
/// Shares of the range at which motions are measured.
constexpr std::array<double, 3> k_amounts{0.35, 0.7, 1.0};

/// What the whole curve has to say to every node, without weights.
struct Bond {
  std::vector<double> places;
  std::vector<double> distances;
  std::vector<ModelVector> moves;
  std::vector<ModelVector> turns;
};

Bond bond_of(const MeasuredParts& parts, const Swing* swing) {
  Bond bond;
  const std::size_t n = parts.patch.inner_count();
  bond.places.resize(n);
  bond.distances.assign(parts.patch.node_count(), 0.0);
  bond.moves.resize(n);
  if (swing != nullptr) bond.turns.resize(n);
  std::vector<ModelVector> ways;
  for (std::size_t i = 0; i < parts.reference.size(); ++i) ways.push_back(parts.target[i] - parts.reference[i]);
  Attachment attachment(parts.reference);
  for (std::size_t node = 0; node < n; ++node) {
    attachment.attach(parts.patch.rests()[node]);
    bond.places[node] = attachment.place();
    bond.distances[node] = attachment.distance();
    bond.moves[node] = attachment.mean_of_points(ways);
    if (swing != nullptr) bond.turns[node] = attachment.mean_of_segments(swing->turns());
  }
  return bond;
}

class Trial {
 public:
  Trial(const MeasuredParts& parts, double minimum, double maximum)
      : parts_(parts), meter_(parts.patch), minimum_(minimum), maximum_(maximum) {}

  /// A motion with weights, on all nodes, measured.
  struct Outcome {
    std::shared_ptr<const CurveMotion> motion;
    std::vector<Passenger> passengers;  ///< one an inner node
    Strain strain;
  };

  [[nodiscard]] Outcome attempt(const std::shared_ptr<const CurveMotion>& motion, const Bond& bond,
                                std::span<const double> weights) {
    Outcome outcome{motion, {}, {}};
    const std::size_t n = parts_.patch.inner_count();
    const auto last = static_cast<double>(motion->segment_count() - 1);
    std::vector<ModelVector> turns;
    if (motion->swing() != nullptr) turns.assign(parts_.patch.node_count(), ModelVector{0});
    for (std::size_t node = 0; node < n; ++node) {
      Passenger passenger;
      const double segment = std::min(std::floor(bond.places[node]), last);
      passenger.segment = static_cast<std::uint32_t>(segment);
      passenger.fraction = bond.places[node] - segment;
      passenger.weight = weights[node];
      passenger.rest = parts_.patch.rests()[node];
      passenger.move = bond.moves[node] * weights[node];
      if (motion->swing() != nullptr) turns[node] = passenger.turn = bond.turns[node] * weights[node];
      outcome.passengers.push_back(passenger);
    }
    const Carriage carriage(motion, parts_.surface, outcome.passengers, false);
    moves_.assign(parts_.patch.node_count(), ModelVector{0});
    std::vector<ModelVector> turned(turns.size());
    const auto at = [&](double amount) {
      carriage.displacements(amount, work_, std::span(moves_).first(n));
      for (std::size_t i = 0; i < turns.size(); ++i) turned[i] = turns[i] * amount;
      outcome.strain = worse(outcome.strain, meter_.measure(moves_, turned));
    };
    for (const double share : k_amounts) at(share * maximum_);
    if (minimum_ < 0.0) at(minimum_);
    return outcome;
  }

 private:
  const MeasuredParts& parts_;
  Strainmeter meter_;
  double minimum_;
  double maximum_;
  CarriageWorkspace work_;
  std::vector<ModelVector> moves_;
};

bool better(const Strain& a, const Strain& b, double factor) {
  if (a.turned_over != b.turned_over) return a.turned_over < b.turned_over;
  return a.energy < factor * b.energy;
}

}  // namespace

base::Result<MeasuredMotion> measured_motion(const MeasuredParts& parts, Mode mode, double minimum, double maximum) {
  const auto motion_of = [&](Mode one) {
    return std::make_shared<const CurveMotion>(parts.reference, parts.target, one, Turning::swung);
  };
  const auto straight = mode == Mode::rotate ? nullptr : motion_of(Mode::translate);
  const auto swing = mode == Mode::translate ? nullptr : motion_of(Mode::rotate);
  const Bond bond = bond_of(parts, swing ? swing->swing() : nullptr);
  Trial trial(parts, minimum, maximum);
  std::optional<Trial::Outcome> best;
  for (const double depth : {0.0, 0.4, 0.8}) {
    const auto weights = depth > 0.0 ? parts.falloff.weights(depth, bond.distances) : parts.falloff.weights();
    for (const auto& [motion, factor] : {std::pair{straight, 1.0}, std::pair{swing, k_measurably}}) {
      if (!motion) continue;
      auto outcome = trial.attempt(motion, bond, weights);
      if (!best || better(outcome.strain, best->strain, factor)) best = std::move(outcome);
    }
    if (best->strain.turned_over == 0) break;
  }

  MeasuredMotion result;
  std::vector<Passenger> passengers;
  for (std::size_t i = 0; i < parts.region.vertices.size(); ++i) {
    Passenger passenger = best->passengers[parts.patch.nodes()[i]];
    if (!(passenger.weight > 0.0)) continue;
    const std::uint32_t v = parts.region.vertices[i];
    auto to_rest = parts.canvas.to_rest(v);
    if (!to_rest) return to_rest.error();
    passenger.to_rest = *to_rest;
    passenger.rest = parts.canvas.positions()[v];
    passengers.push_back(passenger);
    result.vertices.push_back(v);
    result.weights.push_back(passenger.weight);
  }
  result.vertices.shrink_to_fit();
  result.weights.shrink_to_fit();
  result.strain = best->strain;
  result.strain.node = parts.patch.vertex(best->strain.node);
  result.carriage = Carriage(best->motion, parts.surface, passengers, parts.canvas.carried());
  return result;
}

}  // namespace penpose::articulation
