#include "core/animation/signal/blinks.h"

#include <algorithm>
#include <cmath>

#include "core/animation/signal/ramps.h"
#include "core/animation/signal/statistics.h"

namespace penpose::animation {
namespace {

constexpr double k_longest_blink_s = 0.45;  ///< at half of its depth
constexpr double k_window_s = 0.6;          ///< to each side, of what is usual around a frame
constexpr double k_stands_out = 4.5;        ///< tremors that a dip is deep, to be a blink by itself
constexpr double k_backed = 2.0;            ///< the same where the tracker's own column rises too
constexpr double k_surely = 1.15;           ///< times these a dip is a blink for sure
constexpr double k_brief = 0.7;             ///< of a dip, that has to be over within the longest blink
constexpr double k_least_rise = 0.08;       ///< of all that the tracker's own column can say
constexpr double k_least_dip = 0.12;        ///< of the usual opening
constexpr double k_least_tremor = 0.01;     ///< the same: openings are told no finer

/// 0 up to `low`, 1 from `high` on.
double between(double value, double low, double high) { return std::clamp((value - low) / (high - low), 0.0, 1.0); }

/// How far a signal is below what is usual around each frame.
std::vector<double> dips_of(const std::vector<double>& signal, std::size_t half) {
  const std::vector<double> usual = running_median(signal, half);
  std::vector<double> dips;
  for (std::size_t f = 0; f < signal.size(); ++f) dips.push_back(usual[f] - signal[f]);
  return dips;
}

/// Each number a little of its neighbours: a blink is no single frame.
std::vector<double> softened(const std::vector<double>& numbers) {
  std::vector<double> soft(numbers.size());
  for (std::size_t f = 0; f < numbers.size(); ++f) {
    soft[f] =
        0.25 * numbers[f == 0 ? 0 : f - 1] + 0.5 * numbers[f] + 0.25 * numbers[f + 1 == numbers.size() ? f : f + 1];
  }
  return soft;
}

/// The deviation of what differs from frame to frame, from how the signal bends in most frames.
double tremor_of(const std::vector<double>& signal) {
  std::vector<double> bends;
  for (std::size_t f = 1; f + 1 < signal.size(); ++f) bends.push_back(signal[f - 1] - 2 * signal[f] + signal[f + 1]);
  const double of_a_bend = std::sqrt(6.0);
  return std::max(spread(bends) / of_a_bend, k_least_tremor);
}

/// Finds the blinks of a clip.
class Blinks {
 public:
  Blinks(const std::vector<std::vector<double>>& seen, std::span<const LidPoints> points,
         std::span<const double> confidence, double fps, std::span<const double> column)
      : seen_(seen),
        points_(points),
        confidence_(confidence),
        frames_(confidence.size()),
        half_(std::max<std::size_t>(2, static_cast<std::size_t>(k_window_s * fps + 0.5))),
        longest_(std::max<std::size_t>(3, static_cast<std::size_t>(k_longest_blink_s * fps + 0.5))) {
    if (column.size() == frames_) measure_column(column);
    std::vector<double> both(frames_, 0.0);
    for (const auto& eye : seen_) {
      for (std::size_t f = 0; f < frames_; ++f) both[f] += eye[f] / static_cast<double>(seen_.size());
    }
    find(both, 1.0);
    // A wink dips one eye alone; it has to stand out more, for there are more chances to be taken in.
    for (const auto& eye : seen_) find(eye, 1.3);
    settle_courses();
    std::stable_sort(all.begin(), all.end(), [](const Blink& a, const Blink& b) { return a.peak < b.peak; });
  }

  std::vector<Blink> all;

 private:
  /// What a blink was found from.
  struct Event {
    Ramps ramps;
    std::vector<double> dips;
    double deviation = 0;
  };

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

  /// How far the eye is wider shortly before or after, whichever is less, and whichever is more.
  struct Brief {
    double less = 0;
    double more = 0;
  };
  [[nodiscard]] std::vector<Brief> brief_dips(const std::vector<double>& soft) const {
    std::vector<Brief> dips;
    for (std::size_t f = 0; f < frames_; ++f) {
      const auto at = soft.begin() + static_cast<std::ptrdiff_t>(f);
      const auto before = std::min(f, longest_);
      const auto after = std::min(frames_ - 1 - f, longest_);
      const double widest_before = *std::max_element(at - static_cast<std::ptrdiff_t>(before), at + 1) - soft[f];
      const double widest_after = *std::max_element(at, at + static_cast<std::ptrdiff_t>(after) + 1) - soft[f];
      // An eye that stays narrow beyond it, or was so before, has not blinked.
      constexpr double k_comes_back = 0.6;
      const double less = std::min(widest_before, widest_after);
      const double more = std::max(widest_before, widest_after);
      dips.push_back({less < k_comes_back * more ? 0.0 : less, more});
    }
    return dips;
  }

  /// Whether the eye is narrow around the frame for longer than a blink is.
  [[nodiscard]] bool stays_narrow(const std::vector<double>& soft, const Brief& brief, std::size_t peak) const {
    const double half_open = soft[peak] + 0.5 * brief.more;
    std::size_t first = peak;
    std::size_t last = peak;
    while (first > 0 && soft[first - 1] < half_open) --first;
    while (last + 1 < frames_ && soft[last + 1] < half_open) ++last;
    return last - first > longest_;
  }

  void find(const std::vector<double>& opening, double strictness) {
    std::vector<double> dips = dips_of(opening, half_);
    const std::vector<double> soft = softened(dips);
    const std::vector<double> soft_opening = softened(opening);
    const std::vector<Brief> brief = brief_dips(soft_opening);
    std::vector<double> returns;
    for (const Brief& one : brief) returns.push_back(one.less);
    const double tremor = std::max(spread(soft), spread(returns));
    struct Found {
      std::size_t frame;
      double sure;
    };
    std::vector<Found> found;
    for (std::size_t f = 1; f + 1 < frames_; ++f) {
      const bool peak = soft[f] > soft[f - 1] && soft[f] >= soft[f + 1] && confidence_[f] > 0;
      // What opens or closes at one side alone is no blink.
      if (!peak || brief[f].less < k_brief * soft[f] || stays_narrow(soft_opening, brief[f], f)) continue;
      const double least = (rises_.empty() ? 0.75 : 0.5) * k_least_dip;
      const double rise = rises_.empty() ? 0.0 : rise_near(f);
      const auto stands_out = [&](double tremors) {
        const double deep = tremors * strictness * tremor;
        return deep > 0 ? between(soft[f], deep, k_surely * deep) : 1.0;
      };
      const double alone = rises_.empty()
                               ? stands_out(k_stands_out)
                               : stands_out(k_stands_out) * between(rise, least_rise_, k_surely * least_rise_);
      const double need = std::max(0.35, least_rise_);
      const double backed = rises_.empty() ? 0.0 : stands_out(k_backed) * between(rise, need, k_surely * need);
      const double sure = std::max(alone, backed) * between(soft[f], least, k_surely * least);
      if (sure > 0) found.push_back({f, sure});
    }
    // The deepest first: what lies beside it is a part of it.
    std::stable_sort(found.begin(), found.end(),
                     [&](const Found& a, const Found& b) { return soft[a.frame] > soft[b.frame]; });
    const double deviation = tremor_of(opening);
    for (const Found& one : found) add(dips, one.frame, one.sure, deviation);
  }

  /// `dips`: without the blinks that were added before.
  void add(std::vector<double>& dips, std::size_t peak, double sure, double deviation) {
    for (const Blink& other : all) {
      if (other.shape.size() > 0 && peak > other.first && peak < other.last && other.shape[peak - other.first] > 0.1)
        return;
    }
    const double half_depth = 0.5 * dips[peak];
    std::size_t first = peak;
    std::size_t last = peak;
    while (first > 0 && peak - first <= longest_ && dips[first] > half_depth) --first;
    while (last + 1 < frames_ && last - peak <= longest_ && dips[last] > half_depth) ++last;
    if (last - first > longest_ + 1) return;  // eyes that stay narrow
    // Some tens of frames determine a ramp; at a thousand a second, more of them would only cost time.
    constexpr std::size_t k_most_reach = 60;
    const std::size_t reach = std::clamp<std::size_t>((last - first) * 3 / 2 + 1, 4, k_most_reach);
    first = peak < reach ? 0 : peak - reach;
    last = std::min(peak + reach, frames_ - 1);
    if (first + 1 > peak || last < peak + 1) return;
    const std::span<const double> around = std::span(dips).subspan(first, last - first + 1);
    const Ramps ramps = fit_ramps(around, peak - first, deviation);
    if (!(ramps.height >= 0.5 * k_least_dip)) return;
    Blink blink{first, peak, last, {}, {}, {}, sure};
    if (!rises_.empty()) blink.sure *= std::clamp(2 * rise_near(peak), 0.5, 1.0);
    Event event{ramps, std::vector<double>(around.begin(), around.end()), deviation};
    for (std::size_t f = first; f <= last; ++f) {
      blink.shape.push_back(ramps.at(static_cast<double>(f - first)));
      dips[f] -= ramps.height * blink.shape.back();
    }
    all.push_back(std::move(blink));
    events_.push_back(std::move(event));
  }

  /// A person's blinks take as long as that person's others, as far as they are not seen to differ; and all points of
  /// the lids tell where one is, each as far as it moves in blinks.
  void settle_courses() {
    for (Blink& blink : all) measure(blink);
    find_parts();
    std::vector<Ramps> ramps;
    std::vector<double> deviations;
    for (std::size_t i = 0; i < all.size(); ++i) {
      Event& event = events_[i];
      look_closely(all[i], event);
      event.ramps = fit_ramps(event.dips, all[i].peak - all[i].first, event.deviation);
      ramps.push_back(event.ramps);
      deviations.push_back(event.deviation);
    }
    const auto usual = usual_ramps(ramps, quantile(deviations, 0.5));
    for (std::size_t i = 0; i < all.size(); ++i) {
      Blink& blink = all[i];
      Event& event = events_[i];
      if (usual) event.ramps = fit_ramps(event.dips, blink.peak - blink.first, event.deviation, usual);
      const Ramps course = closed_in_a_frame(event.ramps);
      for (std::size_t f = 0; f < blink.shape.size(); ++f) blink.shape[f] = event.ramps.at(static_cast<double>(f));
      measure(blink);
      blink.lids.clear();
      for (std::size_t f = 0; f < blink.shape.size(); ++f) {
        // Lids set off softly, and a corner there that lies a little earlier is no jump.
        const auto t = static_cast<double>(f);
        const double here = course.at(t);
        const double soft = 0.25 * course.at(t - 1) + 0.5 * here + 0.25 * course.at(t + 1);
        blink.lids.push_back(here * here + soft * (1 - here));
      }
    }
  }

  void measure(Blink& blink) const {
    blink.depth.clear();
    for (const auto& eye : seen_) blink.depth.push_back(depth_in(eye, blink));
  }

  /// An eye that dips by far less than the other has no part in it.
  [[nodiscard]] static bool takes_part(const Blink& blink, std::size_t eye) {
    constexpr double k_least = 0.4;
    return blink.depth[eye] >= k_least * *std::max_element(blink.depth.begin(), blink.depth.end());
  }

  /// How far each point of the lids goes in blinks, for an eye that goes all its usual way.
  void find_parts() {
    for (std::size_t e = 0; e < points_.size(); ++e) {
      parts_.emplace_back();
      dips_of_points_.emplace_back();
      for (const auto& point : points_[e]) {
        dips_of_points_[e].push_back(dips_of(point, half_));
        double along = 0;
        double square = 0;
        for (const Blink& blink : all) {
          for (std::size_t f = blink.first; f <= blink.last && takes_part(blink, e); ++f) {
            const double s = blink.depth[e] * blink.shape[f - blink.first];
            along += s * dips_of_points_[e].back()[f];
            square += s * s;
          }
        }
        parts_[e].push_back(square > 0 ? along / square : 0.0);
      }
    }
  }

  /// The dips of a blink by all points that move in it.
  void look_closely(const Blink& blink, Event& event) const {
    std::vector<double> dips(event.dips.size(), 0.0);
    double square = 0;
    for (std::size_t e = 0; e < parts_.size(); ++e) {
      if (!takes_part(blink, e)) continue;
      for (std::size_t k = 0; k < parts_[e].size(); ++k) {
        for (std::size_t f = blink.first; f <= blink.last; ++f) {
          dips[f - blink.first] += parts_[e][k] * dips_of_points_[e][k][f];
        }
        square += parts_[e][k] * parts_[e][k];
      }
    }
    if (!(square > 0)) return;
    for (double& dip : dips) dip /= square;
    event.dips = std::move(dips);
  }

  /// How deep an eye goes in the blink: by least squares of its course, beside what the eye does anyway, which goes
  /// straight on from before it to after it.
  [[nodiscard]] double depth_in(const std::vector<double>& eye, const Blink& blink) const {
    constexpr std::size_t k_level = 5;
    const std::size_t before = blink.first < k_level ? 0 : blink.first - k_level;
    const std::size_t after = std::min(blink.last + 1, frames_ - 1);
    const std::span<const double> all_frames(eye);
    const double start = quantile(all_frames.subspan(before, blink.first + 1 - before), 0.5);
    const double end = quantile(all_frames.subspan(after, std::min(k_level, frames_ - after)), 0.5);
    double along = 0;
    double square = 0;
    for (std::size_t f = blink.first; f <= blink.last; ++f) {
      const double s = blink.shape[f - blink.first];
      const double t = static_cast<double>(f - blink.first) / static_cast<double>(blink.last - blink.first);
      along += s * (start * (1 - t) + end * t - eye[f]);
      square += s * s;
    }
    return std::max(0.0, along / square);
  }

  std::vector<Event> events_;  ///< one a blink of `all`, until that is sorted
  const std::vector<std::vector<double>>& seen_;
  std::span<const LidPoints> points_;
  std::vector<std::vector<double>> parts_;                        ///< one an eye and a point
  std::vector<std::vector<std::vector<double>>> dips_of_points_;  ///< the same, one a frame
  std::span<const double> confidence_;
  std::size_t frames_;
  std::size_t half_;
  std::size_t longest_;
  double least_rise_ = 0.25;   ///< of the usual rise: where the column rises by less, there is no blink
  std::vector<double> rises_;  ///< of the tracker's column, 0..1
};

}  // namespace

std::vector<Blink> find_blinks(const std::vector<std::vector<double>>& seen, std::span<const LidPoints> points,
                               std::span<const double> confidence, double frames_per_s,
                               std::span<const double> column) {
  return Blinks(seen, points, confidence, frames_per_s, column).all;
}

}  // namespace penpose::animation
