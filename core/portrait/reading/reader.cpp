#include "core/portrait/reading/reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/math.h"

namespace penpose::portrait {
namespace {

/// Stretches that a line may be before all are assigned together: so many, none less likely than the best by more.
constexpr std::size_t k_candidates = 8;
constexpr double k_window = 18.0;
/// What a line may be that is drawn over the face is told by what it lies near more than by how it is bent.
constexpr double k_window_over = 60.0;
/// Doubt of pose and placement once they were read.
constexpr double k_doubt_left = 0.35;
/// Readings that are followed to their end.
constexpr std::size_t k_followed = 3;
/// First guesses that are refined, and those of them that are turned, too.
constexpr std::size_t k_refined = 4, k_turned = 2;
/// Rounds of labels and placement in turn; of the pose alone.
constexpr int k_rounds = 5;
/// Doubt of placement and proportions while the first pose is sought: it would shrink a face to explain a laugh.
constexpr double k_first_doubt = 0.1;
constexpr double k_any = std::numeric_limits<double>::infinity();
/// Labellings tried for one sheet; the best of them is taken then.
constexpr std::size_t k_most_trials = 1500;
/// Labels are tried with other controls, too, where those chosen already come this near to the best energy.
constexpr double k_promising = 8.0;
/// What a line costs in the energy of a reading that is nothing known.
constexpr double k_nothing_energy = 42.0, k_nothing_over = 80.0;

/// A line tells so many things apart from where it is: times the logarithm of the scale, what a likelihood on the face
/// lacks to be one on the sheet. Without it, a drawing shrunk to a dot would be like anything.
constexpr double k_measured = 16.0;

/// Doubt of the placement of what was drawn over the face, of what is usual; and what a reading elsewhere costs.
constexpr double k_doubt_in_view = 0.05, k_elsewhere = 40.0;

/// How many lines are something known.
double known_lines(std::span<const Label> labels) {
  return static_cast<double>(
      std::count_if(labels.begin(), labels.end(), [](const Label& label) { return label.stretch != k_nothing; }));
}

/// Lines that leave so many times what the middle one leaves, or a steady hand, are weighed down.
constexpr double k_off = 10.0, k_steady_squares = 12.0;

/// The weight of each line by what it leaves; none where all are about as near.
std::vector<double> weights_of(std::span<const double> left) {
  std::vector<double> sorted;
  for (const double squares : left) {
    if (squares > 0.0) sorted.push_back(squares);  // else nothing known
  }
  if (sorted.empty()) return {};
  std::stable_sort(sorted.begin(), sorted.end());
  const double most = k_off * std::max(k_steady_squares, sorted[sorted.size() / 2]);
  if (sorted.back() <= most) return {};
  std::vector<double> weights;
  for (const double squares : left) weights.push_back(squares > most ? most / squares : 1.0);
  return weights;
}

/// An order in which labellings are kept apart.
std::vector<std::size_t> key_of(std::span<const Label> labels) {
  std::vector<std::size_t> key;
  for (const Label& label : labels)
    key.push_back(label.stretch == k_nothing ? k_nothing : 2 * label.stretch + (label.reversed ? 1 : 0));
  return key;
}

}  // namespace

SheetReader::SheetReader(const FaceView& face, std::span<const Trace> lines, const Sketching& sketching)
    : face_(face),
      stretches_(face),
      lines_(lines),
      hand_(sketching.hand),
      in_view_(sketching.in_view),
      still_(sketching.still),
      given_(sketching.given),
      apart_(distances_between(lines)),
      first_(face, Belief{{}, {}, 1.0}, sketching.hand),
      system_(face, stretches_, lines, sketching.hand),
      solver_(face) {}

std::vector<Trace> SheetReader::on_face(const Placement& placement) const {
  std::vector<Trace> out;
  for (const Trace& line : lines_) out.push_back(placement(line));
  return out;
}

std::vector<std::vector<Label>> SheetReader::candidates(const Likeness& likeness, std::span<const Trace> lines) {
  auto out = candidates_of(likeness, face_, lines, k_candidates, hand_.over ? k_window_over : k_window);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!is_given(i)) continue;
    out[i] = {*given_[i] == k_nothing ? Label{k_nothing, false, k_nothing_cost}
                                      : label_of_curve(likeness, face_, lines[i], *given_[i])};
  }
  return out;
}

SheetReader::Guess SheetReader::guess_from(Placement placement, int rounds) {
  Guess guess;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Trace> lines = on_face(placement);
    const auto assigned = assign(face_, candidates(first_, lines), apart_, hand_);
    guess = {assigned.labels, placement,
             assigned.cost - k_measured * known_lines(assigned.labels) * base::log(placement.scale())};
    std::vector<Match> matches;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Label& label = assigned.labels[i];
      if (label.stretch == k_nothing) continue;
      const double unrest = face_.unrest(stretches_[label.stretch].curve);
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
  const auto best_of = [](std::vector<Guess> all, std::size_t count) {
    std::stable_sort(all.begin(), all.end(), [](const Guess& a, const Guess& b) { return a.cost < b.cost; });
    std::vector<Guess> best;
    for (Guess& guess : all) {
      const auto key = key_of(guess.labels);
      const bool known =
          std::any_of(best.begin(), best.end(), [&](const Guess& one) { return key_of(one.labels) == key; });
      if (!known && best.size() < count) best.push_back(std::move(guess));
    }
    return best;
  };
  std::vector<Guess> all;
  for (const Placement& placement : first_placements(face_, lines_)) all.push_back(guess_from(placement, 1));
  all = best_of(std::move(all), k_refined);
  // The best of them turned a little to either side.
  const std::size_t upright = std::min(all.size(), k_turned);
  for (std::size_t i = 0; i < upright; ++i) {
    const Placement placement = all[i].placement;
    for (const Placement& turned : turned_about(placement, lines_)) all.push_back(guess_from(turned, 1));
  }
  all = best_of(std::move(all), k_refined);
  for (Guess& guess : all) guess = guess_from(guess.placement, k_rounds);
  return best_of(std::move(all), k_followed);
}

void SheetReader::join_shut_lips(std::vector<Label>& labels) {
  const auto& parting = face_.parting();
  if (!parting) return;
  std::array<bool, 2> drawn{};
  bool others = false;
  for (Label& label : labels) {
    label.also = k_nothing;
    if (label.stretch == k_nothing) continue;
    const std::size_t curve = stretches_[label.stretch].curve;
    for (std::size_t k = 0; k < drawn.size(); ++k) drawn[k] = drawn[k] || curve == (*parting)[k];
    others = others || (face_.part(curve) == Part::mouth && curve != (*parting)[0] && curve != (*parting)[1]);
  }
  // Over a face, with a border of the lips beside it, it may be the edge of an open mouth.
  if (drawn[0] == drawn[1] || (hand_.over && others)) return;
  const std::size_t shown = (*parting)[drawn[0] ? 0 : 1], other = (*parting)[drawn[0] ? 1 : 0];
  for (Label& label : labels) {
    if (label.stretch == k_nothing || stretches_[label.stretch].curve != shown) continue;
    const Stretch& stretch = stretches_[label.stretch];
    label.also = stretches_.near(other, stretch.from, stretch.to);
  }
}

std::optional<Reading> SheetReader::read_as(std::vector<Label> labels, std::span<const std::size_t> units,
                                            double most) {
  Reading reading;
  double beside = 0;
  if (hand_.over) join_shut_lips(labels);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i].stretch == k_nothing) {
      beside += hand_.over ? k_nothing_over : k_nothing_energy;
      continue;
    }
    const Stretch& own = stretches_[labels[i].stretch];
    if (!own.whole()) beside += k_part_cost;
    for (std::size_t k = 0; k < i; ++k) {
      if (labels[k].stretch == k_nothing) continue;
      beside += cost_of_both(own, stretches_[labels[k].stretch], apart_[i * labels.size() + k]);
    }
  }
  if (hand_.over) {
    std::vector<double> drawn(face_.curve_count(), 0.0);
    for (const Label& label : labels) {
      if (label.stretch == k_nothing) continue;
      const Stretch& stretch = stretches_[label.stretch];
      drawn[stretch.curve] += stretch.to - stretch.from;
    }
    beside += cost_of_lone_curves(face_, drawn, hand_);
  }
  if (beside > most) return std::nullopt;
  const SquaresOfDoubt squares = system_.squares(labels);
  if (!still_ && std::isfinite(most) && solver_.energy_with(squares, units) + beside > most) return std::nullopt;
  reading.pose = still_ ? solver_.still(squares) : solver_.solve(squares, units);
  auto fitted = system_.fitted(reading.pose.shares);
  // Lines that are far off what all others tell do not pull the face about; what they leave counts all the same.
  double ignored = 0;
  for (int round = 0; round < 2; ++round) {
    const std::vector<double> left = system_.left(labels, reading.pose.shares, fitted);
    const auto weights = weights_of(left);
    if (weights.empty()) break;
    const SquaresOfDoubt weighed = system_.squares(labels, weights);
    reading.pose = still_ ? solver_.still(weighed) : solver_.solve(weighed, reading.pose.units);
    fitted = system_.fitted(reading.pose.shares);
    const auto now = system_.left(labels, reading.pose.shares, fitted);
    ignored = 0;
    for (std::size_t i = 0; i < now.size(); ++i) ignored += (1.0 - weights[i]) * now[i];
  }
  reading.placement = fitted.placement;
  reading.proportions = fitted.proportions;
  double unusual = 0;
  for (std::size_t p = 0; p < reading.proportions.size(); ++p) {
    const double times = reading.proportions[p] / hand_.proportion;
    unusual += times * times;
  }
  // What is unlikely in itself does not become likelier because lines are met badly.
  reading.energy = reading.pose.energy + solver_.energy_of(reading.pose.squares + ignored - unusual) -
                   solver_.energy_of(reading.pose.squares) + unusual + beside -
                   k_measured * known_lines(labels) * base::log(std::max(1e-9, system_.guess().scale()));
  reading.labels = std::move(labels);
  return reading;
}

std::vector<Label> SheetReader::fine(std::vector<Label> labels, const Reading& reading) {
  const auto lines = on_face(reading.placement);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i].stretch == k_nothing) continue;
    const Stretch& part = stretches_[labels[i].stretch];
    if (part.whole()) continue;
    const Stretch& whole = face_.curve(part.curve);
    Trace there = whole.rest;
    for (std::size_t j = 0; j < whole.ways.size(); ++j) {
      for (std::size_t k = 0; k < k_numbers; ++k) there[k] += reading.pose.shares[j] * whole.ways[j][k];
    }
    for (std::size_t p = 0; p < reading.proportions.size(); ++p) {
      for (std::size_t k = 0; k < k_numbers; ++k) there[k] += reading.proportions[p] * whole.proportions[p][k];
    }
    double from = share_nearest(there, {lines[i][0], lines[i][1]});
    double to = share_nearest(there, {lines[i][k_numbers - 2], lines[i][k_numbers - 1]});
    if (labels[i].reversed) std::swap(from, to);
    if (from < to) labels[i].stretch = stretches_.near(part.curve, from, to);
  }
  return labels;
}

Reading SheetReader::settled(std::vector<Label> labels, const Placement& placement, double doubt) {
  constexpr int k_settling = 3;
  system_.bend(std::vector<double>(face_.controls().size(), 0.0), {});
  system_.place_near(placement, std::min(doubt, k_first_doubt));
  auto last = key_of(labels);
  Reading reading = *read_as(std::move(labels), {}, k_any);
  for (int round = 0; round < k_settling; ++round) {
    system_.bend(reading.pose.shares, reading.proportions);
    if (round > 0) system_.place_near(placement, doubt);
    const Likeness likeness(face_, {reading.pose.shares, reading.proportions, k_doubt_left}, hand_);
    const auto lines = on_face(reading.placement);
    auto assigned = assign(face_, candidates(likeness, lines), apart_, hand_);
    const bool same = key_of(assigned.labels) == last;
    last = key_of(assigned.labels);
    reading = *read_as(fine(std::move(assigned.labels), reading), reading.pose.units, k_any);
    if (same && round > 0) break;
  }
  return reading;
}

Reading SheetReader::improved(Reading reading) {
  constexpr int k_improving = 6;
  std::set<std::vector<std::size_t>> tried;
  for (int round = 0; round < k_improving; ++round) {
    system_.bend(reading.pose.shares, reading.proportions);
    const Likeness near(face_, {reading.pose.shares, reading.proportions, k_doubt_left}, hand_);
    const auto lines = on_face(reading.placement);
    Reading best = reading;
    const auto consider = [&](std::vector<Label> labels) {
      if (trials_ >= k_most_trials || !tried.insert(key_of(labels)).second) return;
      ++trials_;
      auto one = read_as(fine(std::move(labels), reading), reading.pose.units, best.energy + k_promising);
      if (one && one->energy < best.energy - 1e-6) best = std::move(*one);
    };
    std::vector<std::vector<Label>> options;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      constexpr std::size_t k_curves = 3;
      const double within = hand_.over ? 40.0 : 14.0;
      const Trace& line = lines[i];
      if (is_given(i)) {
        options.emplace_back();
        continue;
      }
      auto some = curves_for(near, face_, line, k_curves, within);
      for (const Label& label : curves_for(first_, face_, line, k_curves, within)) {
        if (std::find(some.begin(), some.end(), label) == some.end()) some.push_back(label);
      }
      options.push_back(std::move(some));
    }
    const auto curve_of = [&](const Label& label) {
      return label.stretch == k_nothing ? k_nothing : stretches_[label.stretch].curve;
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const Label& other : options[i]) {
        if (other == reading.labels[i]) continue;
        auto labels = reading.labels;
        labels[i] = other;
        consider(labels);
        for (std::size_t k = 0; k < lines.size(); ++k) {
          if (k == i || other.stretch == k_nothing || curve_of(reading.labels[k]) != curve_of(other)) continue;
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

double SheetReader::doubt_of(const Placement& placement) const {
  constexpr double k_rotated = 0.15, k_shifted = 60.0;
  const bool here = std::abs(placement.along - 1.0) + std::abs(placement.across) < k_rotated &&
                    geometry::distance(placement.shift, {0, 0}) < k_shifted;
  return in_view_ && here ? k_doubt_in_view : 1.0;
}

Reading SheetReader::read_from(const Reading& other, const Stretches& stretches) {
  std::vector<Label> labels = other.labels;
  for (Label& label : labels) {
    if (label.stretch == k_nothing) continue;
    const Stretch& one = stretches[label.stretch];
    label.stretch = stretches_.near(one.curve, one.from, one.to);
  }
  system_.bend(other.pose.shares, other.proportions);
  system_.place_near(other.placement, doubt_of(other.placement));
  return improved(*read_as(std::move(labels), other.pose.units, k_any));
}

Reading SheetReader::read() {
  Reading best;
  double most = k_any;
  if (in_view_) {
    const Placement here;
    best = improved(settled(guess_from(here, 1).labels, here, k_doubt_in_view));
    // Few lines say nothing of where the face is; many of which most are known are where they are.
    constexpr std::size_t k_enough = 5;
    constexpr double k_most_known = 0.7;
    const auto count = static_cast<double>(lines_.size());
    if (lines_.size() < k_enough || known_lines(best.labels) > k_most_known * count) return best;
    most = best.energy - k_elsewhere;
  }
  for (const Guess& guess : guesses()) {
    Reading one = improved(settled(guess.labels, guess.placement, 1.0));
    if (one.energy >= most) continue;
    most = one.energy;
    best = std::move(one);
  }
  return best;
}

}  // namespace penpose::portrait
