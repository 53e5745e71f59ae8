#include "core/portrait/reader.h"

#include <algorithm>
#include <cmath>

namespace penpose::portrait {
namespace {

constexpr std::size_t k_candidates = 15;
constexpr double k_window = 40.0;
/// Doubt of pose and placement once they were read.
constexpr double k_doubt_left = 0.35;
/// Readings that are followed to their end.
constexpr std::size_t k_followed = 2;

/// An order in which labellings are kept apart.
std::vector<std::size_t> key_of(std::span<const Label> labels) {
  std::vector<std::size_t> key;
  for (const Label& label : labels) key.push_back(2 * label.stretch + (label.reversed ? 1 : 0));
  return key;
}

}  // namespace

SheetReader::SheetReader(const FaceView& face, std::span<const Trace> lines, bool still)
    : face_(face),
      lines_(lines),
      still_(still),
      first_(face, Belief{}),
      system_(face, lines, k_usual_proportion),
      solver_(face) {}

std::vector<Trace> SheetReader::on_face(const Placement& placement) const {
  std::vector<Trace> out;
  for (const Trace& line : lines_) out.push_back(placement(line));
  return out;
}

SheetReader::Guess SheetReader::guess_from(Placement placement) {
  constexpr int k_rounds = 5;
  Guess guess;
  for (int round = 0; round < k_rounds; ++round) {
    const std::vector<Trace> lines = on_face(placement);
    const auto candidates = candidates_of(first_, face_, lines, k_candidates, k_window);
    const auto assigned = assign(face_, candidates, distances_between(lines));
    guess = {assigned.labels, placement, assigned.cost};
    std::vector<Match> matches;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Label& label = assigned.labels[i];
      const double unrest = face_.unrest(face_.stretches()[label.stretch].curve);
      Match match{lines_[i], first_.mean(label.stretch), 1.0 / (unrest * unrest)};
      if (label.reversed) {
        for (std::size_t k = 0; k < k_points; ++k) {
          match.line[2 * k] = lines_[i][2 * (k_points - 1 - k)];
          match.line[2 * k + 1] = lines_[i][2 * (k_points - 1 - k) + 1];
        }
      }
      matches.push_back(match);
    }
    const Placement next = placed(matches, placement);
    const double change = std::abs(next.along - placement.along) + std::abs(next.across - placement.across);
    const PxPoint shift = next.shift - placement.shift;
    placement = next;
    if (change < 1e-3 * next.scale() && shift.x * shift.x + shift.y * shift.y < 0.25) break;
  }
  return guess;
}

std::vector<SheetReader::Guess> SheetReader::guesses() {
  std::vector<Guess> all;
  for (const Placement& placement : first_placements(face_, lines_)) {
    Guess guess = guess_from(placement);
    const auto key = key_of(guess.labels);
    const auto same = std::find_if(all.begin(), all.end(), [&](const Guess& one) { return key_of(one.labels) == key; });
    if (same == all.end()) all.push_back(std::move(guess));
  }
  std::stable_sort(all.begin(), all.end(), [](const Guess& a, const Guess& b) { return a.cost < b.cost; });
  if (all.size() > k_followed) all.resize(k_followed);
  return all;
}

Reading SheetReader::read_as(std::vector<Label> labels, std::span<const std::size_t> units) {
  Reading reading;
  const SquaresOfDoubt squares = system_.squares(labels);
  reading.pose = still_ ? solver_.still(squares) : solver_.solve(squares, units);
  const auto fitted = system_.fitted(reading.pose.shares);
  reading.placement = fitted.placement;
  reading.proportions = fitted.proportions;
  reading.energy = reading.pose.energy;
  const auto distances = distances_between(on_face(reading.placement));
  const auto stretches = face_.stretches();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Stretch& own = stretches[labels[i].stretch];
    if (!own.whole()) reading.energy += k_part_cost;
    for (std::size_t k = 0; k < i; ++k)
      reading.energy += cost_of_both(own, stretches[labels[k].stretch], distances[i * labels.size() + k]);
  }
  reading.labels = std::move(labels);
  return reading;
}

Reading SheetReader::settled(std::vector<Label> labels) {
  constexpr int k_rounds = 3;
  system_.bend(std::vector<double>(face_.controls().size(), 0.0));
  Reading reading = read_as(std::move(labels), {});
  for (int round = 0; round < k_rounds; ++round) {
    system_.bend(reading.pose.shares);
    const Likeness likeness(face_, {reading.pose.shares, reading.proportions, k_doubt_left});
    const auto lines = on_face(reading.placement);
    const auto candidates = candidates_of(likeness, face_, lines, k_candidates, k_window);
    auto assigned = assign(face_, candidates, distances_between(lines));
    const bool same = key_of(assigned.labels) == key_of(reading.labels);
    reading = read_as(std::move(assigned.labels), reading.pose.units);
    if (same) break;
  }
  return reading;
}

Reading SheetReader::improved(Reading reading) {
  constexpr int k_rounds = 6;
  std::map<std::vector<std::size_t>, double> tried;
  for (int round = 0; round < k_rounds; ++round) {
    system_.bend(reading.pose.shares);
    const Likeness near(face_, {reading.pose.shares, reading.proportions, k_doubt_left});
    const auto lines = on_face(reading.placement);
    Reading best = reading;
    const auto consider = [&](std::vector<Label> labels) {
      if (!tried.emplace(key_of(labels), 0.0).second) return;
      Reading one = read_as(std::move(labels), reading.pose.units);
      if (one.energy < best.energy - 1e-6) best = std::move(one);
    };
    std::vector<std::vector<Label>> options;
    for (const Trace& line : lines) {
      constexpr std::size_t k_curves = 4;
      constexpr double k_within = 25.0;
      auto some = curves_for(near, face_, line, k_curves, k_within);
      for (const Label& label : curves_for(first_, face_, line, k_curves, k_within)) {
        if (std::find(some.begin(), some.end(), label) == some.end()) some.push_back(label);
      }
      options.push_back(std::move(some));
    }
    const auto curve_of = [&](const Label& label) { return face_.stretches()[label.stretch].curve; };
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const Label& other : options[i]) {
        if (other == reading.labels[i]) continue;
        auto labels = reading.labels;
        labels[i] = other;
        consider(labels);
        for (std::size_t k = 0; k < lines.size(); ++k) {
          if (k == i || curve_of(reading.labels[k]) != curve_of(other)) continue;
          for (const Label& instead : options[k]) {
            if (curve_of(instead) == curve_of(other)) continue;
            labels[k] = instead;
            consider(labels);
          }
          labels[k] = reading.labels[k];
        }
      }
    }
    if (!(best.energy < reading.energy - 1e-6)) break;
    reading = std::move(best);
  }
  return reading;
}

Reading SheetReader::read() {
  Reading best;
  bool found = false;
  for (const Guess& guess : guesses()) {
    Reading one = improved(settled(guess.labels));
    if (!found || one.energy < best.energy) best = std::move(one);
    found = true;
  }
  return best;
}

}  // namespace penpose::portrait
