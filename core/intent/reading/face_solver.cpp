#include "core/intent/reading/face_solver.h"

#include <algorithm>

#include "core/intent/reading/robust_selection.h"
#include "core/intent/reading/value_search.h"

namespace penpose::intent {
namespace {

/// A reading that leaves more than this share of the squares of every line goes no way to speak of.
constexpr double k_some_way = 0.85;
/// Other readings are matched on their own before one is taken: so many of each round, within this of the best energy.
/// A line is read in full as aligned in another way where a first look comes as near.
constexpr std::size_t k_rivals = 3;
constexpr double k_window = 6.0;
/// Rounds of matching a choice on its own, for linear rigs and others.
constexpr int k_matches = 2;
constexpr int k_general_matches = 4;

}  // namespace

Choice FaceSolver::trusted(const Choice& before, Choice after) const {
  if (reader_.linear()) return after;
  for (std::size_t i = 0; i < after.variables.size(); ++i) {
    if (!reader_.turns(after.variables[i])) continue;
    const auto at = std::lower_bound(before.variables.begin(), before.variables.end(), after.variables[i]);
    const bool had = at != before.variables.end() && *at == after.variables[i];
    const double was = had ? before.values[static_cast<std::size_t>(at - before.variables.begin())] : 0.0;
    after.values[i] = std::clamp(after.values[i], was - k_trust, was + k_trust);
  }
  return after;
}

Reading FaceSolver::matched(Choice choice) {
  const ReadingCosts costs = reader_.reading_costs();
  const int rounds = reader_.linear() ? k_matches : k_general_matches;
  for (int k = 0; k < rounds && !choice.variables.empty(); ++k) {
    reader_.look(choice, true, b_.quadratic, choice.variables);
    RobustSelection selection(b_.quadratic, costs, reader_.doubt());
    choice = trusted(choice, selection.fit(choice.units));
    evaluations += selection.evaluations();
  }
  const double energy = reader_.matched_energy(choice, choice.costs);
  return {std::move(choice), energy};
}

Reading FaceSolver::read_choices() {
  const ReadingCosts costs = reader_.reading_costs();
  const std::size_t rounds = reader_.linear() ? options_.rounds : options_.general_rounds;
  Choice choice;
  std::vector<Choice> rivals;
  for (std::size_t round = 0; round < rounds; ++round) {
    reader_.look(choice, round > 0, b_.quadratic);
    RobustSelection selection(b_.quadratic, costs, reader_.doubt());
    choice = trusted(choice, selection.select(selection.fit(choice.units), options_.most_units));
    evaluations += selection.evaluations();
    if (round > 0 && round + 1 < rounds) continue;
    for (Choice& one : selection.best(k_rivals, k_window)) rivals.push_back(std::move(one));
  }
  Reading best = matched(choice);
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    const auto before = rivals.begin() + static_cast<std::ptrdiff_t>(i);
    const auto same = [&](const Choice& one) { return one.units == rivals[i].units; };
    if (same(choice) || std::any_of(rivals.begin(), before, same)) continue;
    Reading one = matched(rivals[i]);
    if (one.energy < best.energy - 1e-9) best = std::move(one);
  }
  return best;
}

Reading FaceSolver::read_aligned() {
  reader_.leave_carriers(true);
  Reading best = read_choices();
  if (!reader_.leaves_carriers()) return best;
  const bool goes = goes_some_way(best.choice);
  reader_.leave_carriers(false);
  if (goes) return best;
  Reading all = read_choices();
  return all.energy < best.energy - 1e-9 ? all : best;
}

bool FaceSolver::goes_some_way(const Choice& choice) {
  const std::vector<double> left = reader_.squares_left(choice);
  const std::vector<double> asked = reader_.squares_left({});
  for (std::size_t c = 0; c < left.size(); ++c) {
    if (left[c] < k_some_way * asked[c]) return true;
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
  return matched(trusted(choice, std::move(found))).energy;
}

Reading FaceSolver::read() {
  const std::size_t lines = reader_.line_count();
  for (std::size_t c = 0; c < lines; ++c) reader_.align(c, 0);
  Reading best = read_aligned();
  for (std::size_t c = 0; c < lines; ++c) {
    std::size_t chosen = 0;
    double gain = most_to_gain(best, c);
    for (std::size_t a = 1; a < reader_.alignments(c).size(); ++a) {
      if (reader_.alignments(c)[a].charge >= gain) continue;
      reader_.align(c, a);
      // Where a first look comes nowhere near it so, it is not how the line was drawn.
      if (first_look(best.choice, c) > best.energy + k_window) continue;
      Reading one = read_aligned();
      if (!(one.energy < best.energy - 1e-9)) continue;
      best = std::move(one);
      chosen = a;
      gain = most_to_gain(best, c);
    }
    reader_.align(c, chosen);
  }
  // What comes hardly nearer is not what was meant.
  return goes_some_way(best.choice) ? best : matched({});
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
