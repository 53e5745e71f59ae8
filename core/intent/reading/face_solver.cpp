#include "core/intent/reading/face_solver.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/intent/choosing/robust_selection.h"
#include "core/intent/reading/value_search.h"

namespace penpose::intent {
namespace {

/// A reading that leaves more than this share of the squares of every line goes no way to speak of.
constexpr double k_some_way = 0.85;
/// Other readings are matched on their own before one is taken: so many of each round, within this of the best energy.
/// A line is read in full as aligned in another way where a first look comes as near.
constexpr std::size_t k_rivals = 3;
constexpr double k_window = 6.0;
/// Readings are offered beside the one taken that are within this of it.
constexpr double k_offered = 12.0;
/// What leaves more than this of them is no way that anybody could have meant.
constexpr double k_any_way = 0.97;
/// Rounds of matching a choice on its own, for linear rigs and others.
constexpr int k_matches = 2, k_general_matches = 4;
/// A window that leaves nothing out.
constexpr double k_however_far = 1e9;
/// So many choices of a selection are looked through for other readings.
constexpr std::size_t k_looked_through = 64;

/// Whether what the first moves and the second does not is a part of `exchanged`, and something where that is.
bool is_exchange(const std::vector<std::size_t>& first, const std::vector<std::size_t>& second,
                 const std::vector<std::size_t>& exchanged) {
  std::vector<std::size_t> alone;
  std::set_difference(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(alone));
  return alone.empty() == exchanged.empty() &&
         std::includes(exchanged.begin(), exchanged.end(), alone.begin(), alone.end());
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
  const double energy = reader_.matched_energy(choice, choice.costs);
  return {std::move(choice), energy};
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
    for (Choice& one : selection.best(k_rivals, k_window)) rivals.push_back(std::move(one));
    if (round + 1 == rounds && options_.others > 0) asides = exchanges(selection, choice);
  }
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
  return best;
}

std::vector<Choice> FaceSolver::exchanges(const RobustSelection& selection, const Choice& from) const {
  // Where nothing moves, what would have is kept however far above it is.
  const double window = from.units.empty() ? k_however_far : k_offered;
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

Reading FaceSolver::read_best() {
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
      if (lines == 1 && asked < reader_.face_costs().asks_from) continue;
      // Where a first look comes nowhere near it so, it is not how the line was drawn.
      if (first_look(best.choice, c) > best.energy + k_window) continue;
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
  return goes_some_way(best.choice) ? best : matched({});
}

std::vector<std::size_t> FaceSolver::moved_by(const Choice& choice) const {
  const rig::Pose from = reader_.pose_of({});
  const rig::Pose to = reader_.pose_of(choice);
  std::vector<std::size_t> moved;
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (to[i] != from[i]) moved.push_back(i);
  }
  return moved;
}

Reading FaceSolver::read() { return as_taken_before(read_best()); }

Reading FaceSolver::as_taken_before(Reading best) const {
  const std::vector<TakenReading>& taken = reader_.taken();
  if (taken.empty()) return best;
  const std::vector<std::size_t> by_best = moved_by(best.choice);
  const Reading* other = nullptr;
  for (const Reading& one : matched_) {
    if (one.energy > best.energy + reader_.face_costs().taken || (other != nullptr && one.energy >= other->energy))
      continue;
    const std::vector<std::size_t> by_one = moved_by(one.choice);
    const bool exchanged = std::any_of(taken.begin(), taken.end(), [&](const TakenReading& before) {
      return is_exchange(by_best, by_one, before.instead_of) && is_exchange(by_one, by_best, before.taken);
    });
    if (exchanged) other = &one;
  }
  return other != nullptr ? *other : best;
}

std::vector<Reading> FaceSolver::others(const Reading& taken, std::size_t count) {
  std::vector<Reading> all = matched_;
  std::stable_sort(all.begin(), all.end(), [](const Reading& a, const Reading& b) { return a.energy < b.energy; });
  const std::vector<std::size_t> all_moved = moved_by(taken.choice);
  std::vector<std::vector<std::size_t>> known;
  if (!all_moved.empty()) known.push_back(all_moved);
  bool took_back = false;
  reader_.settle(true);
  const double most = taken.energy + (known.empty() ? k_however_far : k_offered);
  std::vector<Reading> out;
  // What moves a little more besides is no other reading.
  const auto is_new = [&](const std::vector<std::size_t>& parameters) {
    return !parameters.empty() && std::none_of(known.begin(), known.end(), [&](const auto& one) {
      return std::includes(parameters.begin(), parameters.end(), one.begin(), one.end());
    });
  };
  for (Reading& one : all) {
    if (out.size() == count) break;
    if (!is_new(moved_by(one.choice))) continue;
    one = matched(std::move(one.choice));
    std::vector<std::size_t> parameters = moved_by(one.choice);
    if (one.energy > most || !is_new(parameters)) continue;
    if (all_moved.empty() && !leaves_less(one.choice, k_any_way)) continue;
    // That one side of a pair was not meant is offered once.
    const bool takes_back = std::includes(all_moved.begin(), all_moved.end(), parameters.begin(), parameters.end());
    if (takes_back && std::exchange(took_back, true)) continue;
    known.push_back(std::move(parameters));
    out.push_back(std::move(one));
  }
  std::stable_sort(out.begin(), out.end(), [](const Reading& a, const Reading& b) { return a.energy < b.energy; });
  return out;
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
