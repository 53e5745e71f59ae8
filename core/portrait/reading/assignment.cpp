#include "core/portrait/reading/assignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penpose::portrait {
namespace {

/// Lines upon each other are this near, px.
constexpr double k_near = 4.0;
/// Stretches that share less of a curve than this continue each other.
constexpr double k_continues = 0.12;
constexpr double k_one_more = 1.0, k_again = 2.0, k_most_apart = 60.0, k_alone_cost = 18.0;
/// A mouth of one line is its opening, never one border of the lips.
constexpr double k_lone_lip = 60.0;
/// Eyes without a mouth are hardly a face.
constexpr double k_no_mouth = 40.0;
/// Nodes of a search; what was found until then is taken.
constexpr std::size_t k_most_nodes = 4'000;

Trace reversed_of(const Trace& line) {
  Trace out{};
  for (std::size_t i = 0; i < k_points; ++i) {
    out[2 * i] = line[2 * (k_points - 1 - i)];
    out[2 * i + 1] = line[2 * (k_points - 1 - i) + 1];
  }
  return out;
}

/// Mean distance of the points of a to the nearest point of b.
double mean_distance(const Trace& a, const Trace& b) {
  double sum = 0;
  for (std::size_t i = 0; i < k_points; ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < k_points; ++k) {
      const double dx = a[2 * i] - b[2 * k], dy = a[2 * i + 1] - b[2 * k + 1];
      least = std::min(least, dx * dx + dy * dy);
    }
    sum += std::sqrt(least);
  }
  return sum / static_cast<double>(k_points);
}

/// Depth first, the lines that are clearest first.
class Search {
 public:
  Search(const FaceView& face, std::span<const std::vector<Label>> candidates, std::span<const double> distances,
         const Hand& hand)
      : face_(face), hand_(hand), candidates_(candidates), distances_(distances), chosen_(candidates.size()) {
    for (std::size_t i = 0; i < candidates.size(); ++i) order_.push_back(i);
    const auto lead = [&](std::size_t i) {
      return candidates[i].size() > 1 ? candidates[i][1].cost - candidates[i][0].cost
                                      : std::numeric_limits<double>::infinity();
    };
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return lead(a) > lead(b); });
    least_.assign(candidates.size() + 1, 0.0);
    for (std::size_t p = candidates.size(); p-- > 0;) least_[p] = least_[p + 1] + candidates[order_[p]].front().cost;
  }
  Assignment run() {
    go(0, 0.0);
    return std::move(best_);
  }

 private:
  double beside(std::size_t p, const Label& label) const {
    const std::size_t i = order_[p];
    const auto stretches = face_.stretches();
    double sum = 0;
    if (label.stretch == k_nothing) return 0.0;
    for (std::size_t q = 0; q < p; ++q) {
      const std::size_t k = order_[q];
      if (chosen_[k].stretch == k_nothing) continue;
      sum +=
          cost_of_both(stretches[label.stretch], stretches[chosen_[k].stretch], distances_[i * candidates_.size() + k]);
    }
    return sum;
  }
  void go(std::size_t p, double cost) {
    if (++nodes_ > k_most_nodes && found_) return;
    if (found_ && cost + least_[p] >= best_.cost) return;
    if (p == order_.size()) {
      if (hand_.over) {
        drawn_.assign(face_.curve_count(), 0.0);
        for (const Label& label : chosen_) {
          if (label.stretch == k_nothing) continue;
          const Stretch& stretch = face_.stretches()[label.stretch];
          drawn_[stretch.curve] += stretch.to - stretch.from;
        }
        cost += cost_of_lone_curves(face_, drawn_, hand_);
        if (found_ && cost >= best_.cost) return;
      }
      best_ = {chosen_, cost};
      found_ = true;
      return;
    }
    for (const Label& label : candidates_[order_[p]]) {
      const double sum = cost + label.cost + beside(p, label);
      if (found_ && sum + least_[p + 1] >= best_.cost) continue;
      chosen_[order_[p]] = label;
      go(p + 1, sum);
    }
  }

  const FaceView& face_;
  Hand hand_;
  std::vector<double> drawn_;  ///< how much of each curve is
  std::span<const std::vector<Label>> candidates_;
  std::span<const double> distances_;
  std::vector<std::size_t> order_;
  std::vector<double> least_;
  std::vector<Label> chosen_;
  Assignment best_;
  bool found_ = false;
  std::size_t nodes_ = 0;
};

/// Every stretch within `window` of the best, the best first.
std::vector<Label> all_for(const Likeness& likeness, const FaceView& face, const Trace& line, double window) {
  const Trace turned = reversed_of(line);
  std::vector<Label> all{{k_nothing, false, k_nothing_cost}};
  double most = k_nothing_cost + window;
  for (std::size_t s = 0; s < face.stretches().size(); ++s) {
    const double forward = likeness.cost(line, s, most);
    const double backward = likeness.cost(turned, s, std::min(most, forward));
    const double cost = std::min(forward, backward);
    if (!std::isfinite(cost)) continue;
    all.push_back({s, backward < forward, cost});
    most = std::min(most, cost + window);
  }
  std::stable_sort(all.begin(), all.end(), [](const Label& a, const Label& b) { return a.cost < b.cost; });
  while (!all.empty() && all.back().cost > all.front().cost + window) all.pop_back();
  return all;
}

}  // namespace

std::vector<std::vector<Label>> candidates_of(const Likeness& likeness, const FaceView& face,
                                              std::span<const Trace> lines, std::size_t count, double window) {
  std::vector<std::vector<Label>> out;
  for (const Trace& line : lines) {
    out.push_back(all_for(likeness, face, line, window));
    if (out.back().size() > count) out.back().resize(count);
  }
  return out;
}

std::vector<Label> curves_for(const Likeness& likeness, const FaceView& face, const Trace& line, std::size_t count,
                              double window) {
  std::vector<Label> best;
  for (const Label& label : all_for(likeness, face, line, window)) {
    const auto curve_of = [&](const Label& one) {
      return one.stretch == k_nothing ? k_nothing : face.stretches()[one.stretch].curve;
    };
    const bool known =
        std::any_of(best.begin(), best.end(), [&](const Label& one) { return curve_of(one) == curve_of(label); });
    if (!known && best.size() < count) best.push_back(label);
  }
  return best;
}

Label label_of_curve(const Likeness& likeness, const FaceView& face, const Trace& line, std::size_t curve) {
  const Trace back = reversed_of(line);
  Label best{curve * FaceView::stretches_per_curve(), false, std::numeric_limits<double>::infinity()};
  for (std::size_t s = 0; s < face.stretches().size(); ++s) {
    if (face.stretches()[s].curve != curve) continue;
    for (const bool reversed : {false, true}) {
      const double cost = likeness.cost(reversed ? back : line, s, std::numeric_limits<double>::infinity());
      if (cost < best.cost) best = {s, reversed, cost};
    }
  }
  return best;
}

std::vector<double> distances_between(std::span<const Trace> lines) {
  std::vector<double> out(lines.size() * lines.size(), 0.0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double apart = std::min(mean_distance(lines[i], lines[k]), mean_distance(lines[k], lines[i]));
      out[i * lines.size() + k] = out[k * lines.size() + i] = apart;
    }
  }
  return out;
}

double cost_of_both(const Stretch& a, const Stretch& b, double apart) {
  if (a.curve != b.curve) return 0.0;
  const double shared = std::min(a.to, b.to) - std::max(a.from, b.from);
  if (shared <= k_continues) return k_one_more;
  const double upon = std::min(k_most_apart, (apart / k_near) * (apart / k_near));
  return k_one_more + (k_again + upon) * std::min(1.0, shared / 0.3);
}

double cost_of_lone_curves(const FaceView& face, std::span<const double> drawn, const Hand& hand) {
  constexpr double k_seen = 0.4;
  const auto count = [&](Part part) {
    std::size_t shown = 0;
    for (std::size_t c = 0; c < face.curve_count(); ++c) shown += face.part(c) == part && drawn[c] > 0.0 ? 1U : 0U;
    return shown;
  };
  const std::size_t lips = count(Part::mouth);
  double cost = 0;
  for (std::size_t c = 0; c < face.curve_count(); ++c) {
    const auto companion = face.companion(c);
    if (!companion || !(drawn[c] > 0.0) || drawn[*companion] >= k_seen) continue;
    const bool lip = face.part(c) == Part::mouth;
    if (hand.over) {
      cost += lip && lips == 1 ? k_lone_lip : 0.0;
    } else {
      cost += lip ? k_lone_lip : k_alone_cost;
    }
  }
  return !hand.over && lips == 0 && count(Part::eye) > 0 ? cost + k_no_mouth : cost;
}

Assignment assign(const FaceView& face, std::span<const std::vector<Label>> candidates,
                  std::span<const double> distances, const Hand& hand) {
  return Search(face, candidates, distances, hand).run();
}

}  // namespace penpose::portrait
