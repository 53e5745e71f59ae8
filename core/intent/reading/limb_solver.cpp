#include "core/intent/reading/limb_solver.h"

#include <vector>

#include "core/intent/reading/value_search.h"

namespace penpose::intent {
namespace {

/// Rivals are choices within this of the best energy.
constexpr double k_limb_window = 12.0;

}  // namespace

Reading LimbSolver::read(Choice choice) {
  reader_.weigh_evenly();
  const std::size_t rounds = options_.limb_rounds;
  std::vector<Choice> rivals;
  for (std::size_t round = 0; round < rounds; ++round) {
    reader_.look(choice, round > 0, b_.quadratic);
    Selection selection(b_.quadratic, reader_.choices(), reader_.costs());
    if (round + 1 == rounds) selection.set_rivals(options_.rivals, k_limb_window);
    const Choice before = choice;
    if (something) selection.forbid_nothing();
    Choice next = selection.select(selection.fit(before.units), options_.most_units);
    if (!reader_.all_bends().empty()) {
      // Alternating bends gain little by the first one alone, so also start from all bends and remove some.
      Choice other = selection.select(selection.fit(reader_.all_bends()), options_.most_units);
      if (other.energy < next.energy - 1e-9 && other.units.size() <= options_.most_units) next = std::move(other);
    }
    choice = near(before, std::move(next));
    evaluations += selection.evaluations();
    reader_.weigh(choice);
    rivals = selection.rivals();
  }
  Reading best = matched(choice);
  bool other = false;
  bool shaped = takes_shape(best);
  for (const Choice& rival : rivals) {
    if (something && rival.units.empty()) continue;
    Reading one = matched(rival);
    const bool takes = takes_shape(one);
    if (takes < shaped || (takes == shaped && !(one.energy < best.energy - 1e-9))) continue;
    best = std::move(one);
    shaped = takes;
    other = true;
  }
  if (other) {
    reader_.look(best.choice, true, b_.quadratic);
    Selection selection(b_.quadratic, reader_.choices(), reader_.costs());
    if (something) selection.forbid_nothing();
    Reading again = matched(selection.select(selection.fit(best.choice.units), options_.most_units));
    evaluations += selection.evaluations();
    if (again.energy < best.energy && takes_shape(again) == shaped) best = std::move(again);
  }
  return best;
}

Reading LimbSolver::matched(Choice choice) {
  for (int k = 0; k < 2; ++k) {
    if (choice.variables.empty()) break;
    reader_.look(choice, true, b_.quadratic, choice.variables);
    Selection selection(b_.quadratic, reader_.choices(), reader_.costs());
    choice = near(choice, selection.fit(choice.units));
    evaluations += selection.evaluations();
  }
  reader_.look(choice, true, b_.quadratic, choice.variables);
  return {choice, reader_.energy(choice, choice.costs)};
}

void LimbSolver::match(const Reading& reading) {
  reader_.look(reading.choice, true, b_.quadratic, reading.choice.variables);
}

void LimbSolver::search(Reading& reading) {
  reader_.look(reading.choice, true, b_.quadratic, reading.choice.variables);
  const Selection selection(b_.quadratic, reader_.choices(), reader_.costs());
  evaluations += search_values(reader_, b_.quadratic, selection, reading.choice,
                               60 * (reading.choice.variables.size() + 1), b_.simplex);
  reading.energy = reader_.energy(reading.choice, reading.choice.costs);
}

bool LimbSolver::takes_shape(const Reading& reading) {
  return !shape || (!reading.choice.units.empty() && reader_.takes_shape(*shape, reading.choice));
}

Choice LimbSolver::near(const Choice& before, Choice after) const {
  return trusted(before, std::move(after), k_trust, [](std::size_t) { return true; });
}

}  // namespace penpose::intent
