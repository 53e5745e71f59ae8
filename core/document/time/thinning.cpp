#include "core/document/time/thinning.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/document/time/timeline.h"

namespace penpose::document {
namespace {

/// Which moments are kept, and how far off that leaves each of the others.
class Thinning {
 public:
  explicit Thinning(const DenseCurves& curves)
      : c_(curves), count_(curves.tolerances.size()), off_(curves.times_s.size(), 0.0), trial_(off_) {}

  [[nodiscard]] const std::vector<std::size_t>& kept() const { return kept_; }
  void keep(std::vector<std::size_t> kept) {
    kept_ = std::move(kept);
    for (std::size_t k = 0; k + 1 < kept_.size(); ++k) measure(k);
  }

  /// Keeps the moment that is farthest off, while one is off by more than its tolerance.
  void add_until_near() {
    for (;;) {
      const auto worst = std::max_element(off_.begin(), off_.end());
      if (!(*worst > 1.0)) return;
      const auto moment = static_cast<std::size_t>(worst - off_.begin());
      const auto place = std::lower_bound(kept_.begin(), kept_.end(), moment);
      const auto k = static_cast<std::size_t>(place - kept_.begin());
      kept_.insert(place, moment);
      measure_about(k);
    }
  }

  /// Leaves out what can be left out, where that makes the least difference first.
  void remove_while_near(const std::vector<bool>& fixed) {
    constexpr double k_stays = 2.0;
    const auto without = [&](std::size_t k) {
      return k == 0 || k + 1 == kept_.size() || fixed[kept_[k]] ? k_stays : off_without(k);
    };
    std::vector<double> off;
    for (std::size_t k = 0; k < kept_.size(); ++k) off.push_back(without(k));
    for (;;) {
      const auto least = std::min_element(off.begin(), off.end());
      if (*least > 1.0) return;
      const auto k = static_cast<std::size_t>(least - off.begin());
      kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(k));
      off.erase(least);
      measure_about(k);
      for (std::size_t i = k >= 3 ? k - 3 : 0; i < kept_.size() && i < k + 3; ++i) off[i] = without(i);
    }
  }

 private:
  [[nodiscard]] double value(std::size_t moment, std::size_t curve) const { return c_.values[moment * count_ + curve]; }

  /// The segments whose shape asks for the kept moment k, measured anew.
  void measure_about(std::size_t k) {
    if (k < kept_.size()) off_[kept_[k]] = 0.0;
    const std::size_t from = k >= 2 ? k - 2 : 0;
    for (std::size_t s = from; s + 1 < kept_.size() && s <= k + 1; ++s) measure(s);
  }

  void measure(std::size_t segment) {
    const std::size_t first = segment >= 1 ? segment - 1 : 0;
    const std::size_t last = std::min(segment + 2, kept_.size() - 1);
    off_[kept_[segment]] = off_[kept_[segment + 1]] = 0.0;
    measure(std::span(kept_).subspan(first, last + 1 - first), segment - first, off_);
  }

  /// Of the segment after moment `at` of neighbours: how far off what lies in it is, in tolerances.
  void measure(std::span<const std::size_t> near, std::size_t at, std::span<double> off) const {
    const std::size_t from = near[at];
    const std::size_t to = near[at + 1];
    if (to == from + 1) return;
    std::array<double, 4> times{};
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < near.size(); ++i) times[i] = c_.times_s[near[i]];
    for (std::size_t m = from + 1; m < to; ++m) off[m] = 0.0;
    for (std::size_t curve = 0; curve < count_; ++curve) {
      for (std::size_t i = 0; i < near.size(); ++i) values[i] = value(near[i], curve);
      const auto slope = [&](std::size_t i) {
        if (i == 0 || i + 1 >= near.size()) return 0.0;
        return monotone_slope((values[i] - values[i - 1]) / (times[i] - times[i - 1]),
                              (values[i + 1] - values[i]) / (times[i + 1] - times[i]));
      };
      const KeySegment between_keys{times[at], times[at + 1], values[at],     values[at + 1],
                                    slope(at), slope(at + 1), KeyKind::smooth};
      for (std::size_t m = from + 1; m < to; ++m) {
        const double between = value_at(between_keys, c_.times_s[m]);
        off[m] = std::max(off[m], std::abs(between - value(m, curve)) / c_.tolerances[curve]);
      }
    }
  }

  /// The farthest that anything is off without the kept moment k.
  [[nodiscard]] double off_without(std::size_t k) {
    std::vector<std::size_t> near;
    const std::size_t first = k >= 3 ? k - 3 : 0;
    const std::size_t last = std::min(k + 3, kept_.size() - 1);
    for (std::size_t i = first; i <= last; ++i) {
      if (i != k) near.push_back(kept_[i]);
    }
    // The segments from two before it to two behind it change.
    double worst = 0;
    for (std::size_t s = 0; s + 1 < near.size(); ++s) {
      const bool cut_before = s == 0 && first > 0;
      const bool cut_behind = s + 2 == near.size() && last + 1 < kept_.size();
      if (cut_before || cut_behind) continue;
      const std::size_t from = s >= 1 ? s - 1 : 0;
      const std::size_t to = std::min(s + 2, near.size() - 1);
      measure(std::span(near).subspan(from, to + 1 - from), s - from, trial_);
      for (std::size_t m = near[s] + 1; m < near[s + 1]; ++m) worst = std::max(worst, trial_[m]);
    }
    return worst;
  }

  const DenseCurves& c_;
  std::size_t count_;
  std::vector<double> off_;    ///< of each moment, in tolerances
  std::vector<double> trial_;  ///< the same where something is left out
  std::vector<std::size_t> kept_;
};

}  // namespace

std::vector<std::size_t> enough_moments(const DenseCurves& curves, std::span<const std::size_t> fixed) {
  const std::size_t n = curves.times_s.size();
  if (n == 0) return {};
  std::vector<bool> stays(n, false);
  stays.front() = stays.back() = true;
  for (const std::size_t moment : fixed) stays[moment] = true;
  std::vector<std::size_t> kept;
  for (std::size_t m = 0; m < n; ++m) {
    if (stays[m]) kept.push_back(m);
  }
  Thinning thinning(curves);
  thinning.keep(std::move(kept));
  thinning.add_until_near();
  thinning.remove_while_near(stays);
  return thinning.kept();
}

}  // namespace penpose::document
