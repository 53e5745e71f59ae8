#include "core/intent/reading/face_solver.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/math.h"
#include "core/intent/choosing/robust_selection.h"
#include "core/intent/reading/value_search.h"

namespace penpose::intent {
namespace {

/// A reading that leaves more than this share of the squares of every line goes no way to speak of.
constexpr double k_some_way = 0.85;
/// Other readings are matched on their own before one is taken: so many of each round, within this of the best energy.
/// A line is read in full as aligned in another way where a first look comes as near.
/// Rounds of matching a choice on its own, for linear rigs and others.
constexpr int k_matches = 2, k_general_matches = 4;
/// A window that leaves nothing out.
constexpr double k_however_far = 1e9;
/// `others` looks at this many readings that look different, and at none that is farther above the best than this.
constexpr std::size_t k_looks_at_most = 12;
constexpr double k_however_unlikely = 20.0;
/// Exchanges within this of the best are matched.
constexpr double k_exchanged = 12.0;
/// So many choices of a selection are looked through for other readings.
constexpr std::size_t k_looked_through = 64;

/// Whether two poses move the same controls, however far.
bool move_the_same(const rig::Pose& start, const rig::Pose& a, const rig::Pose& b) {
  for (std::size_t i = 0; i < start.size(); ++i) {
    if ((a[i] != start[i]) != (b[i] != start[i])) return false;
  }
  return true;
}

}  // namespace

Choice FaceSolver::near(const Choice& before, Choice after) const {
  if (reader_.linear()) return after;
  return trusted(before, std::move(after), k_trust, [&](std::size_t variable) { return reader_.turns(variable); });
}

Reading FaceSolver::matched(Choice choice) {
  const ReadingCosts costs = reader_.reading_costs();
  const int rounds = reader_.linear() ? k_matches : k_general_matches;
  for (int k = 0; k < rounds && !choice.variables.empty(); ++k) {
    reader_.look(choice, true, b_.quadratic, choice.variables);
    RobustSelection selection(b_.quadratic, costs, reader_.doubt());
    choice = near(choice, selection.fit(choice.units));
    evaluations += selection.evaluations();
  }
  Reading reading{std::move(choice), 0.0, {}};
  reading.energy = reader_.matched_energy(reading.choice, reading.choice.costs);
  for (std::size_t c = 0; c < reader_.line_count(); ++c) reading.aligned.push_back(reader_.aligned(c));
  return reading;
}

Reading FaceSolver::read_choices() {
  const ReadingCosts costs = reader_.reading_costs();
  const std::size_t rounds = reader_.linear() ? options_.rounds : options_.general_rounds;
  Choice choice;
  std::vector<Choice> rivals, asides;
  for (std::size_t round = 0; round < rounds; ++round) {
    reader_.look(choice, round > 0, b_.quadratic);
    RobustSelection selection(b_.quadratic, costs, reader_.doubt());
    choice = near(choice, selection.select(selection.fit(choice.units), options_.most_units));
    evaluations += selection.evaluations();
    if (round > 0 && round + 1 < rounds) continue;
    for (Choice& one : selection.best(static_cast<std::size_t>(reader_.weights().rivals), reader_.weights().window))
      rivals.push_back(std::move(one));
    if (round + 1 == rounds && options_.others > 0) asides = exchanges(selection, choice);
  }
  const std::size_t known = matched_.size();
  Reading best = matched(choice);
  matched_.push_back(best);
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    const auto before = rivals.begin() + static_cast<std::ptrdiff_t>(i);
    const auto same = [&](const Choice& one) { return one.units == rivals[i].units; };
    if (same(choice) || std::any_of(rivals.begin(), before, same)) continue;
    Reading one = matched(rivals[i]);
    matched_.push_back(one);
    if (one.energy < best.energy - 1e-9) best = std::move(one);
  }
  // Matched to be offered alone: how much is offered decides nothing.
  for (Choice& one : asides) {
    const auto same = [&](const Reading& other) { return other.choice.units == one.units; };
    if (std::none_of(matched_.begin(), matched_.end(), same)) matched_.push_back(matched(std::move(one)));
  }
  all_.insert(all_.end(), matched_.begin() + static_cast<std::ptrdiff_t>(known), matched_.end());
  return best;
}

std::vector<Choice> FaceSolver::exchanges(const RobustSelection& selection, const Choice& from) const {
  // Where nothing moves, what would have is kept however far above it is.
  const double window = from.units.empty() ? k_however_far : k_exchanged;
  std::vector<Choice> out;
  for (Choice& one : selection.best(k_looked_through, window)) {
    const auto within = [&](const Choice& other) {
      return !other.units.empty() &&
             std::includes(one.units.begin(), one.units.end(), other.units.begin(), other.units.end());
    };
    if (one.units.empty() || within(from) || std::any_of(out.begin(), out.end(), within)) continue;
    out.push_back(std::move(one));
    if (out.size() == options_.others + 2) break;
  }
  return out;
}

Reading FaceSolver::read_aligned() {
  reader_.leave_carriers(true);
  matched_.clear();
  Reading best = read_choices();
  if (!reader_.leaves_carriers()) return best;
  const bool goes = goes_some_way(best.choice);
  reader_.leave_carriers(false);
  if (goes) return best;
  Reading all = read_choices();
  return all.energy < best.energy - 1e-9 ? all : best;
}

bool FaceSolver::goes_some_way(const Choice& choice) { return leaves_less(choice, k_some_way); }

bool FaceSolver::leaves_less(const Choice& choice, double share) {
  const std::vector<double> left = reader_.squares_left(choice);
  const std::vector<double> asked = reader_.squares_left({});
  for (std::size_t c = 0; c < left.size(); ++c) {
    if (left[c] < share * asked[c]) return true;
  }
  return false;
}

double FaceSolver::most_to_gain(const Reading& reading, std::size_t c) {
  const std::vector<double> left = reader_.squares_left(reading.choice);
  return reader_.alignments(c)[reader_.aligned(c)].charge + reader_.doubt().added_by(c, left) +
         reader_.reading_costs().costs_for(reading.choice, reader_.doubt().group_of(c));
}

double FaceSolver::first_look(const Choice& choice, std::size_t c) {
  const ReadingCosts costs = reader_.reading_costs();
  const auto kept = costs.units_besides(choice.units, reader_.doubt().group_of(c));
  reader_.look(choice, false, b_.quadratic);
  RobustSelection selection(b_.quadratic, costs, reader_.doubt());
  Choice found = selection.extend(selection.fit(kept), options_.most_units);
  evaluations += selection.evaluations();
  return matched(near(choice, std::move(found))).energy;
}

void FaceSolver::align_as(const Reading& reading) {
  for (std::size_t c = 0; c < reading.aligned.size(); ++c) reader_.align(c, reading.aligned[c]);
}

std::vector<Reading> FaceSolver::all() const {
  std::vector<Reading> all = all_;
  std::stable_sort(all.begin(), all.end(), [](const Reading& a, const Reading& b) { return a.energy < b.energy; });
  std::vector<Reading> out;
  for (Reading& one : all) {
    const auto same = [&](const Reading& other) {
      return other.aligned == one.aligned && other.choice.units == one.choice.units;
    };
    if (std::none_of(out.begin(), out.end(), same)) out.push_back(std::move(one));
  }
  return out;
}

Reading FaceSolver::read() {
  const std::size_t lines = reader_.line_count();
  for (std::size_t c = 0; c < lines; ++c) reader_.align(c, 0);
  Reading best = read_aligned();
  std::vector<Reading> of_best = matched_;
  for (std::size_t c = 0; c < lines; ++c) {
    std::size_t chosen = 0;
    double gain = most_to_gain(best, c);
    for (std::size_t a = 1; a < reader_.alignments(c).size(); ++a) {
      if (reader_.alignments(c)[a].charge >= gain) continue;
      reader_.align(c, a);
      // A part of a curve drawn where it is would say nothing: then all of it is meant to be shorter. Beside other
      // lines it says that the curve stays.
      const double asked = reader_.squares_left({})[c];
      if (lines == 1 && asked < reader_.weights().asks_from) continue;
      // Where a first look comes nowhere near it so, it is not how the line was drawn.
      if (first_look(best.choice, c) > best.energy + reader_.weights().window) continue;
      Reading one = read_aligned();
      if (!(one.energy < best.energy - 1e-9)) continue;
      if (lines == 1 ? reader_.squares_left(one.choice)[c] > k_some_way * asked : one.choice.units.empty()) continue;
      best = std::move(one);
      of_best = matched_;
      chosen = a;
      gain = most_to_gain(best, c);
    }
    reader_.align(c, chosen);
  }
  matched_ = std::move(of_best);
  // What comes hardly nearer is not what was meant.
  return leaves_less(best.choice, reader_.weights().gives_up) ? best : matched({});
}

std::vector<OtherReading> FaceSolver::others(const Reading& taken, std::size_t count, double& probability) {
  const inference::Weights& weights = reader_.weights();
  const bool nothing = taken.choice.units.empty();
  reader_.settle(true);
  const rig::Pose start = reader_.pose_of({});
  std::vector<Reading> found = all();
  const double least = found.empty() ? taken.energy : std::min(taken.energy, found.front().energy);
  const auto likelihood = [&](double energy) { return base::exp(least - energy); };
  std::vector<OtherReading> looks{{reader_.pose_of(taken.choice), 0.0, likelihood(taken.energy)}};
  double sum = looks.front().probability;
  for (Reading& one : found) {
    if (one.aligned == taken.aligned && one.choice.units == taken.choice.units) continue;
    const double above = one.energy - taken.energy;
    if (looks.size() > k_looks_at_most || (!nothing && above > k_however_unlikely)) break;
    const double share = likelihood(one.energy);
    align_as(one);
    const bool moves = !one.choice.units.empty();
    OtherReading other{reader_.pose_of(moves ? matched(std::move(one.choice)).choice : one.choice), above, share};
    const auto same = std::find_if(looks.begin(), looks.end(), [&](const OtherReading& known) {
      return move_the_same(start, known.pose, other.pose) || reader_.unlikeness(known.pose, other.pose) < weights.alike;
    });
    sum += share;
    if (same == looks.end()) {
      looks.push_back(std::move(other));
    } else {
      same->probability += share;
    }
  }
  align_as(taken);
  for (OtherReading& one : looks) one.probability /= sum;
  probability = looks.front().probability;
  looks.erase(looks.begin());
  std::erase_if(looks, [&](const OtherReading& one) {
    return one.pose == start || (!nothing && one.probability < weights.offered);
  });
  std::stable_sort(looks.begin(), looks.end(),
                   [](const OtherReading& a, const OtherReading& b) { return a.probability > b.probability; });
  if (looks.size() > count) looks.resize(count);
  return looks;
}

void FaceSolver::settle(Reading& reading) {
  reader_.settle(true);
  reading = matched(std::move(reading.choice));
  reader_.look(reading.choice, true, b_.quadratic, reading.choice.variables);
  const ReadingCosts costs = reader_.reading_costs();
  evaluations += search_values(reader_, b_.quadratic, costs, reading.choice, 60 * (reading.choice.variables.size() + 1),
                               b_.simplex);
  reading.energy = reader_.energy(reading.choice, reading.choice.costs);
}

}  // namespace penpose::intent
