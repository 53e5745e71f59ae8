#include "core/animation/face/rest_choice.h"

#include <algorithm>
#include <cmath>

#include "core/animation/head/head_fit.h"
#include "core/animation/signal/statistics.h"
#include "core/base/numbers.h"

namespace penpose::animation {
namespace {

constexpr std::size_t k_least_frames = 10;

/// How far frames are from rest: a sum of squares, each in units of how much its number usually varies.
class Distances {
 public:
  Distances(std::span<const std::size_t> frames, double least_spread)
      : frames_(frames), least_(least_spread), sums_(frames.size(), 0.0) {}

  /// Numbers of the frames, which are at rest at the median of those in `among` (all of them if empty).
  void add(const std::vector<double>& numbers, std::span<const std::size_t> among, double weight, double least) {
    std::vector<double> usual;
    for (const std::size_t i : among) usual.push_back(numbers[i]);
    const auto& said = among.empty() ? numbers : usual;
    const double rest = quantile(said, 0.5);
    const double scale = std::max(spread(said), least);
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const double apart = scale > 0 ? (numbers[i] - rest) / scale : 0.0;
      sums_[i] += weight * apart * apart;
    }
  }
  void add(const std::vector<double>& numbers, std::span<const std::size_t> among, double weight) {
    add(numbers, among, weight, least_);
  }
  [[nodiscard]] const std::vector<double>& sums() const { return sums_; }

 private:
  std::span<const std::size_t> frames_;
  double least_;
  std::vector<double> sums_;
};

/// How far the head is turned: out of the picture's plane about one axis or the other, or within it.
double turn_of(const PointTrack& track, const StillTrack& still, std::size_t frame, int axis) {
  const auto& told = track.frames[frame].rotation;
  const glm::dmat3& turn = told ? *told : still.turns[frame].rotation;
  return axis < 2 ? turn[2][axis] : turn[0][1];
}

/// Frames that show a face of which the head is turned about as it mostly is: seen from elsewhere, lips and lids look
/// narrower than they are.
std::vector<std::size_t> level_frames(const PointTrack& track, const StillTrack& still) {
  std::vector<std::size_t> frames;
  for (std::size_t f = 0; f < still.confidence.size(); ++f) {
    if (still.confidence[f] > 0) frames.push_back(f);
  }
  std::vector<bool> level(still.confidence.size(), true);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> turns;
    for (const std::size_t f : frames) turns.push_back(turn_of(track, still, f, axis));
    const double usual = quantile(turns, 0.5);
    constexpr double k_least_turn = 0.1;  // radians
    const double most = std::max(1.5 * spread(turns), k_least_turn);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      if (std::abs(turns[i] - usual) > most) level[frames[i]] = false;
    }
  }
  std::vector<std::size_t> kept;
  for (const std::size_t f : frames) {
    if (level[f]) kept.push_back(f);
  }
  return kept.size() < k_least_frames ? frames : kept;
}

double width_of(const TrackedCurve& curve, const TrackFrame& frame) {
  return geometry::distance(frame.points[curve.points.front()], frame.points[curve.points.back()]);
}

}  // namespace

std::optional<EyeCurves> lips_of(std::span<const TrackedCurve> curves) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& touches = curves[c].touches;
    if (touches && *touches > c && *touches < curves.size() && curves[*touches].touches == c) {
      return EyeCurves{c, *touches};
    }
  }
  return std::nullopt;
}

std::optional<RestChoice> choose_rest(const PointTrack& track, const StillTrack& still,
                                      std::span<const TrackedCurve> curves, double tremor_px) {
  const auto lips = lips_of(curves);
  const std::vector<EyeCurves> eyes = eyes_of(curves);
  const std::vector<std::size_t> frames = level_frames(track, still);
  if (frames.size() < k_least_frames || !lips) return std::nullopt;
  const TrackFrame& seen_from = track.frames[still.neutral];
  const auto at_frames = [&](const std::vector<double>& all) {
    std::vector<double> result;
    for (const std::size_t f : frames) result.push_back(all[f]);
    return result;
  };

  RestChoice choice;
  std::vector<std::size_t> together;  // places in `frames`
  const double width = width_of(curves[lips->one], seen_from);
  const std::vector<double> gaps = at_frames(openings(still, seen_from, curves[lips->one], curves[lips->other]));
  const double low = quantile(gaps, 0.05);
  const double high = quantile(gaps, 0.95);
  constexpr double k_touch = 0.1;  // of how far the lips open in the clip
  const double most = low + std::max(k_touch * (high - low), 0.5 * tremor_px);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (gaps[i] <= most) together.push_back(i);
  }
  // Points of lips that touch lie a tremor apart; more is a gap.
  choice.lips_together = std::min(std::max(low, 0.0), std::max(tremor_px, 0.01 * width));
  constexpr double k_gap = 0.05;  // of the mouth's width
  choice.near_rest = low <= std::max(k_gap * width, 2 * tremor_px);

  Distances distances(frames, 0.5 * tremor_px);
  std::vector<double> open(frames.size(), 1.0);
  if (!eyes.empty()) {
    std::fill(open.begin(), open.end(), 0.0);
    double usual = 0;
    for (const EyeCurves& eye : eyes) {
      const auto one = at_frames(openings(still, seen_from, curves[eye.one], curves[eye.other]));
      for (std::size_t i = 0; i < frames.size(); ++i) open[i] += one[i] / static_cast<double>(eyes.size());
    }
    usual = quantile(open, 0.5);
    distances.add(open, {}, 1);
    for (double& one : open) one = usual > 0 ? one / usual : 1.0;
  }
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (curves[c].meets) continue;
    const bool of_lips = curves[c].touches.has_value();
    // The whole curve counts as much as an eye.
    const double weight = 0.5 / static_cast<double>(curves[c].points.size());
    for (const std::size_t p : curves[c].points) {
      std::vector<double> x;
      std::vector<double> y;
      for (const std::size_t f : frames) {
        x.push_back(still.offsets[f][p].x);
        y.push_back(still.offsets[f][p].y);
      }
      distances.add(x, of_lips ? together : std::vector<std::size_t>(), weight);
      distances.add(y, of_lips ? together : std::vector<std::size_t>(), weight);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> turns;
    for (const std::size_t f : frames) turns.push_back(turn_of(track, still, f, axis));
    constexpr double k_least_turn = 0.05;  // radians
    distances.add(turns, {}, 1, k_least_turn);
  }

  const auto& sums = distances.sums();
  std::stable_sort(together.begin(), together.end(), [&](std::size_t a, std::size_t b) { return sums[a] < sums[b]; });
  const std::size_t best = together.front();
  choice.frame = frames[best];
  choice.eyes_open = open[best];
  choice.lips_apart = width > 0 ? std::max(0.0, gaps[best] - choice.lips_together) / width : 0.0;
  constexpr std::size_t k_most_alike = 15;
  constexpr double k_alike = 1.0;  // farther from rest than the best, in the sum
  for (std::size_t i = 0; i < std::min(together.size(), k_most_alike); ++i) {
    if (sums[together[i]] <= sums[best] + k_alike) choice.like_it.push_back(frames[together[i]]);
  }
  std::stable_sort(choice.like_it.begin(), choice.like_it.end());
  return choice;
}

std::string explain(const RestChoice& choice) {
  std::string text = "rest is frame " + std::to_string(choice.frame);
  text += choice.lips_apart < 0.01
              ? ": the lips are together, "
              : ": the lips are nearest to each other (" + base::format_fixed(100 * choice.lips_apart, 0) +
                    " % of the mouth's width apart), ";
  text += "the eyes " + base::format_fixed(100 * choice.eyes_open, 0) +
          " % as open as usual, the brows and the head near where they mostly are; --neutral FRAME takes another";
  return text;
}

}  // namespace penpose::animation
