#include "core/animation/blinks.h"

#include <algorithm>
#include <cmath>

#include "core/animation/statistics.h"

namespace penpose::animation {
namespace {

constexpr double k_longest_blink_s = 0.45;  ///< at half of its depth
constexpr double k_longest_onset_s = 0.25;  ///< eyes close faster than they open
constexpr double k_window_s = 0.6;          ///< to each side, of what is usual around a frame
constexpr double k_stands_out = 4.5;        ///< tremors that a dip is deep, to be a blink by itself
constexpr double k_backed = 2.0;            ///< the same where the tracker's own column rises too
constexpr double k_brief = 0.7;             ///< of a dip, that has to be over within the longest blink
constexpr double k_least_rise = 0.08;       ///< of all that the tracker's own column can say
constexpr double k_least_dip = 0.12;        ///< of the usual opening

/// How far a signal is below what is usual around each frame.
std::vector<double> dips_of(const std::vector<double>& signal, std::size_t half) {
  const std::vector<double> usual = running_median(signal, half);
  std::vector<double> dips;
  for (std::size_t f = 0; f < signal.size(); ++f) dips.push_back(usual[f] - signal[f]);
  return dips;
}

/// Two ramps with a floor between, of height one: the best of those that fit into the frames around the peak.
class Ramps {
 public:
  Ramps(const std::vector<double>& dips, std::size_t first, std::size_t peak, std::size_t last) {
    for (std::size_t a = first; a < peak; ++a) {
      for (std::size_t b = std::max(a + 1, peak < first + 2 ? peak : peak - 2); b <= peak; ++b) {
        for (std::size_t c = peak; c <= std::min(peak + 3, last - 1); ++c) {
          for (std::size_t d = c + 1; d <= last; ++d) consider(dips, first, last, {a, b, c, d});
        }
      }
    }
  }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] const std::vector<double>& shape() const { return shape_; }

 private:
  struct Knots {
    std::size_t a, b, c, d;
  };
  static double at(const Knots& k, std::size_t f) {
    if (f <= k.a || f >= k.d) return 0;
    if (f < k.b) return static_cast<double>(f - k.a) / static_cast<double>(k.b - k.a);
    if (f <= k.c) return 1;
    return static_cast<double>(k.d - f) / static_cast<double>(k.d - k.c);
  }
  void consider(const std::vector<double>& dips, std::size_t first, std::size_t last, const Knots& k) {
    double along = 0;
    double square = 0;
    for (std::size_t f = first; f <= last; ++f) {
      const double s = at(k, f);
      along += s * dips[f];
      square += s * s;
    }
    if (!(along > 0)) return;
    const double gain = along * along / square;
    if (!(gain > gain_)) return;
    gain_ = gain;
    height_ = along / square;
    shape_.clear();
    for (std::size_t f = first; f <= last; ++f) shape_.push_back(at(k, f));
  }
  double gain_ = 0;
  double height_ = 0;
  std::vector<double> shape_;
};

/// Finds the blinks of a clip.
class Blinks {
 public:
  Blinks(const std::vector<std::vector<double>>& seen, const std::vector<std::vector<double>>& calm,
         std::span<const double> confidence, double fps, std::span<const double> column)
      : seen_(seen),
        calm_(calm),
        confidence_(confidence),
        frames_(confidence.size()),
        half_(std::max<std::size_t>(2, static_cast<std::size_t>(k_window_s * fps + 0.5))),
        onset_(std::max<std::size_t>(2, static_cast<std::size_t>(k_longest_onset_s * fps + 0.5))),
        longest_(std::max<std::size_t>(3, static_cast<std::size_t>(k_longest_blink_s * fps + 0.5))) {
    if (column.size() == frames_) measure_column(column);
    std::vector<double> both(frames_, 0.0);
    for (const auto& eye : seen_) {
      for (std::size_t f = 0; f < frames_; ++f) both[f] += eye[f] / static_cast<double>(seen_.size());
    }
    find(both, 1.0);
    // A wink dips one eye alone; it has to stand out more, for there are more chances to be taken in.
    for (const auto& eye : seen_) find(eye, 1.3);
    std::stable_sort(all.begin(), all.end(), [](const Blink& a, const Blink& b) { return a.peak < b.peak; });
  }

  std::vector<Blink> all;

 private:
  void measure_column(std::span<const double> column) {
    const std::vector<double> values(column.begin(), column.end());
    std::vector<double> rises = dips_of(values, half_);
    for (double& rise : rises) rise = -rise;
    const double most = quantile(rises, 0.98);
    if (!(most > 0)) return;
    least_rise_ = std::max(least_rise_, k_least_rise / most);
    for (double& rise : rises) rise = std::clamp(rise / most, 0.0, 1.0);
    rises_ = std::move(rises);
  }

  [[nodiscard]] double rise_near(std::size_t frame) const {
    double most = 0;
    const std::size_t reach = std::max<std::size_t>(2, longest_ / 4);
    for (std::size_t f = frame < reach ? 0 : frame - reach; f <= std::min(frame + reach, frames_ - 1); ++f) {
      most = std::max(most, rises_[f]);
    }
    return most;
  }

  /// Each number a little of its neighbours: a blink is no single frame.
  static std::vector<double> softened(const std::vector<double>& numbers) {
    std::vector<double> soft(numbers.size());
    for (std::size_t f = 0; f < numbers.size(); ++f) {
      soft[f] =
          0.25 * numbers[f == 0 ? 0 : f - 1] + 0.5 * numbers[f] + 0.25 * numbers[f + 1 == numbers.size() ? f : f + 1];
    }
    return soft;
  }

  /// How far the eye is wider both shortly before and shortly after.
  [[nodiscard]] std::vector<double> brief_dips(const std::vector<double>& soft) const {
    std::vector<double> dips;
    for (std::size_t f = 0; f < frames_; ++f) {
      const auto at = soft.begin() + static_cast<std::ptrdiff_t>(f);
      const auto before = std::min(f, onset_);
      const auto after = std::min(frames_ - 1 - f, longest_);
      const double widest_before = *std::max_element(at - static_cast<std::ptrdiff_t>(before), at + 1);
      const double widest_after = *std::max_element(at, at + static_cast<std::ptrdiff_t>(after) + 1);
      const double before_that = widest_before - soft[f];
      const double after_that = widest_after - soft[f];
      // An eye that stays narrow beyond it, or was so before, has not blinked.
      constexpr double k_comes_back = 0.6;
      const double less = std::min(before_that, after_that);
      dips.push_back(less < k_comes_back * std::max(before_that, after_that) ? 0.0 : less);
    }
    return dips;
  }

  /// Whether the eye is narrow around the frame for longer than a blink is.
  [[nodiscard]] bool stays_narrow(const std::vector<double>& soft, const std::vector<double>& brief,
                                  std::size_t peak) const {
    const double half_open = soft[peak] + 0.5 * brief[peak];
    std::size_t first = peak;
    std::size_t last = peak;
    while (first > 0 && soft[first - 1] < half_open) --first;
    while (last + 1 < frames_ && soft[last + 1] < half_open) ++last;
    return last - first > longest_;
  }

  void find(const std::vector<double>& opening, double strictness) {
    const std::vector<double> dips = dips_of(opening, half_);
    const std::vector<double> soft = softened(dips);
    const std::vector<double> soft_opening = softened(opening);
    const std::vector<double> brief = brief_dips(soft_opening);
    const double tremor = std::max(spread(soft), spread(brief));
    std::vector<std::size_t> found;
    for (std::size_t f = 1; f + 1 < frames_; ++f) {
      const bool peak = soft[f] > soft[f - 1] && soft[f] >= soft[f + 1] && confidence_[f] > 0;
      // What opens or closes at one side alone is no blink.
      if (!peak || brief[f] < k_brief * soft[f] || stays_narrow(soft_opening, brief, f) ||
          soft[f] < (rises_.empty() ? 0.75 : 0.5) * k_least_dip)
        continue;
      const double rise = rises_.empty() ? 0.0 : rise_near(f);
      const bool alone = soft[f] > k_stands_out * strictness * tremor && (rises_.empty() || rise > least_rise_);
      const bool backed = rise > std::max(0.35, least_rise_) && soft[f] > k_backed * strictness * tremor;
      if (alone || backed) found.push_back(f);
    }
    // The deepest first: what lies beside it is a part of it.
    std::stable_sort(found.begin(), found.end(), [&](std::size_t a, std::size_t b) { return soft[a] > soft[b]; });
    for (const std::size_t f : found) add(dips, f);
  }

  void add(const std::vector<double>& dips, std::size_t peak) {
    const double half_depth = 0.5 * dips[peak];
    std::size_t first = peak;
    std::size_t last = peak;
    while (first > 0 && peak - first <= longest_ && dips[first] > half_depth) --first;
    while (last + 1 < frames_ && last - peak <= longest_ && dips[last] > half_depth) ++last;
    if (last - first > longest_ + 1) return;  // eyes that stay narrow
    // A ramp is told by some tens of frames; at a thousand a second the rest of it would only cost time.
    constexpr std::size_t k_most_reach = 60;
    const std::size_t reach = std::clamp<std::size_t>((last - first) * 3 / 2 + 1, 4, k_most_reach);
    first = peak < reach ? 0 : peak - reach;
    last = std::min(peak + reach, frames_ - 1);
    if (first + 1 > peak || last < peak + 1) return;
    for (const Blink& other : all) {
      if (first < other.last && other.first < last) return;
    }
    const Ramps ramps(dips, first, peak, last);
    if (!(ramps.height() >= 0.5 * k_least_dip)) return;
    Blink blink{first, peak, last, {}, ramps.shape(), {}, {}, 1};
    for (std::size_t e = 0; e < seen_.size(); ++e) measure(e, blink);
    if (!rises_.empty()) blink.backing = std::clamp(2 * rise_near(peak), 0.5, 1.0);
    all.push_back(std::move(blink));
  }

  /// How deep an eye goes in the blink: by least squares of the blink's own shape.
  void measure(std::size_t eye, Blink& blink) const {
    double seen = 0;
    double calm = 0;
    double square = 0;
    for (std::size_t f = blink.first; f <= blink.last; ++f) {
      const double shape = blink.own_shape[f - blink.first];
      seen += shape * (between(calm_[eye], blink.first, blink.last, f) - seen_[eye][f]);
      calm += shape * (between(calm_[eye], blink.first, blink.last, f) - calm_[eye][f]);
      square += shape * shape;
    }
    constexpr double k_kept = 0.75;
    const bool kept = calm > k_kept * seen && calm > 0;
    blink.calm_shape.push_back(kept);
    double deepest = 0;
    for (std::size_t f = blink.first; f <= blink.last; ++f) {
      deepest = std::max(deepest, between(calm_[eye], blink.first, blink.last, f) - calm_[eye][f]);
    }
    blink.calm_depth.push_back(deepest);
    blink.depth.push_back(std::max(0.0, (kept ? calm : seen) / square));
  }

  const std::vector<std::vector<double>>& seen_;
  const std::vector<std::vector<double>>& calm_;
  std::span<const double> confidence_;
  std::size_t frames_;
  std::size_t half_;
  std::size_t onset_;
  std::size_t longest_;
  double least_rise_ = 0.25;   ///< of the usual rise: where the column rises by less, there is no blink
  std::vector<double> rises_;  ///< of the tracker's column, 0..1
};

}  // namespace

double between(const std::vector<double>& signal, std::size_t from, std::size_t to, std::size_t at) {
  if (to == from) return signal[from];
  const double t = static_cast<double>(at - from) / static_cast<double>(to - from);
  return signal[from] * (1 - t) + signal[to] * t;
}

std::vector<Blink> find_blinks(const std::vector<std::vector<double>>& seen,
                               const std::vector<std::vector<double>>& calm, std::span<const double> confidence,
                               double frames_per_s, std::span<const double> column) {
  return Blinks(seen, calm, confidence, frames_per_s, column).all;
}

}  // namespace penpose::animation
