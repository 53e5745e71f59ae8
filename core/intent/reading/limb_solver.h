#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/intent/reading/reader.h"
#include "core/intent/reading/reading.h"
#include "core/intent/reading/value_search.h"

namespace penpose::intent {

/// Rivals are choices within this of the best energy.
inline constexpr double k_rival_window = 12.0;

/// Finds the best reading of strokes along limbs, matching and choosing in turn.
class LimbSolver {
 public:
  LimbSolver(Reader& reader, const SolveOptions& options, SolveWorkspace::Buffers& buffers)
      : reader_(reader), options_(options), b_(buffers) {}

  /// Matching and choosing in turn, from nothing moved or from a first guess.
  Reading read(Choice choice = {}) {
    reader_.weigh_evenly();
    const std::size_t rounds = options_.limb_rounds;
    std::vector<Choice> rivals;
    for (std::size_t round = 0; round < rounds; ++round) {
      reader_.look(choice, round > 0, b_.quadratic);
      Selection selection(b_.quadratic, reader_.choices(), reader_.costs());
      if (round + 1 == rounds) selection.set_rivals(options_.rivals, k_rival_window);
      const Choice before = choice;
      if (something) selection.forbid_nothing();
      Choice next = selection.select(selection.fit(before.units), options_.most_units);
      if (!reader_.all_bends().empty()) {
        // Alternating bends gain little by the first one alone, so also start from all bends and remove some.
        Choice other = selection.select(selection.fit(reader_.all_bends()), options_.most_units);
        if (other.energy < next.energy - 1e-9 && other.units.size() <= options_.most_units) next = std::move(other);
      }
      choice = trusted(before, std::move(next));
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

  /// A choice of units, matched on its own, and its energy.
  Reading matched(Choice choice) {
    for (int k = 0; k < 2; ++k) {
      if (choice.variables.empty()) break;
      reader_.look(choice, true, b_.quadratic, choice.variables);
      Selection selection(b_.quadratic, reader_.choices(), reader_.costs());
      choice = trusted(choice, selection.fit(choice.units));
      evaluations += selection.evaluations();
    }
    reader_.look(choice, true, b_.quadratic, choice.variables);
    return {choice, reader_.energy(choice, choice.costs)};
  }

  /// Matches the curves at the pose of a reading.
  void match(const Reading& reading) { reader_.look(reading.choice, true, b_.quadratic, reading.choice.variables); }

  /// Downhill simplex on the values of the last reading.
  void search(Reading& reading) {
    reader_.look(reading.choice, true, b_.quadratic, reading.choice.variables);
    const Selection selection(b_.quadratic, reader_.choices(), reader_.costs());
    evaluations += search_values(reader_, b_.quadratic, selection, reading.choice,
                                 60 * (reading.choice.variables.size() + 1), b_.simplex);
    reading.energy = reader_.energy(reading.choice, reading.choice.costs);
  }

  std::size_t evaluations = 0;
  /// Readings must move something (Selection::forbid_nothing).
  bool something = false;
  /// The line whose shape readings must take on (Reader::takes_shape), if any.
  std::optional<std::size_t> shape;

 private:
  [[nodiscard]] bool takes_shape(const Reading& reading) {
    return !shape || (!reading.choice.units.empty() && reader_.takes_shape(*shape, reading.choice));
  }

  Choice trusted(const Choice& before, Choice after) const {
    for (std::size_t i = 0; i < after.variables.size(); ++i) {
      const auto at = std::lower_bound(before.variables.begin(), before.variables.end(), after.variables[i]);
      const bool had = at != before.variables.end() && *at == after.variables[i];
      const double was = had ? before.values[static_cast<std::size_t>(at - before.variables.begin())] : 0.0;
      after.values[i] = std::clamp(after.values[i], was - k_trust, was + k_trust);
    }
    return after;
  }

  Reader& reader_;
  const SolveOptions& options_;
  SolveWorkspace::Buffers& b_;
};

}  // namespace penpose::intent
