#include "core/animation/signal/ramps.h"

#include <algorithm>
#include <cmath>

#include "core/animation/signal/statistics.h"

namespace penpose::animation {
namespace {

/// How ramps explain dips.
class Problem {
 public:
  Problem(std::span<const double> dips, double deviation, const std::optional<UsualRamps>& usual)
      : dips_(dips), deviation_(deviation), usual_(usual) {}

  /// What they explain of the squares of the dips, less what is unusual about them, in the same unit. Sets the height.
  double gain(Ramps& ramps) const {
    double along = 0;
    double square = 0;
    for (std::size_t f = 0; f < dips_.size(); ++f) {
      const double s = ramps.at(static_cast<double>(f));
      along += s * dips_[f];
      square += s * s;
    }
    ramps.height = along > 0 ? along / square : 0.0;
    const double explained = along > 0 ? along * along / square : 0.0;
    if (!usual_) return explained;
    const auto unusual = [&](double value, double middle, double differs) {
      const double apart = (value - middle) / differs;
      return apart * apart;
    };
    return explained - deviation_ * deviation_ *
                           (unusual(ramps.down, usual_->down, usual_->down_differs) +
                            unusual(ramps.floor, usual_->floor, usual_->floor_differs) +
                            unusual(ramps.up, usual_->up, usual_->up_differs));
  }

 private:
  std::span<const double> dips_;
  double deviation_;
  const std::optional<UsualRamps>& usual_;
};

constexpr double k_shortest = 0.5;  ///< frames that a ramp takes at least

bool possible(const Ramps& r, double end) {
  return r.start >= 0 && r.down >= k_shortest && r.floor >= 0 && r.up >= k_shortest &&
         r.start + r.down + r.floor + r.up <= end;
}

}  // namespace

double Ramps::at(double frame) const {
  const double t = frame - start;
  const double left = down + floor + up - t;
  if (t <= 0 || left <= 0) return 0;
  return std::min({1.0, t / down, left / up});
}

Ramps fit_ramps(std::span<const double> dips, std::size_t peak, double deviation,
                const std::optional<UsualRamps>& usual) {
  const Problem problem(dips, deviation, usual);
  const auto end = static_cast<double>(dips.size() - 1);
  const auto middle = static_cast<double>(peak);
  const double step = std::max(0.5, end / 32);
  const double floor = std::max(2.0, end / 8);
  Ramps best;
  double most = 0;
  for (double closed = middle; closed >= std::max(step, middle - floor); closed -= step) {
    for (double opens = closed; opens <= std::min(middle + 1.5 * floor, end - step); opens += step) {
      for (double open = closed - step; open >= 0; open -= step) {
        for (double ends = opens + step; ends <= end; ends += step) {
          Ramps one{open, closed - open, opens - closed, ends - opens, 0};
          const double gain = problem.gain(one);
          if (gain > most) {
            most = gain;
            best = one;
          }
        }
      }
    }
  }
  if (!(most > 0)) return {};
  constexpr double k_finest = 0.01;
  constexpr int k_most_sweeps = 12;
  for (double way = 0.5 * step; way > k_finest; way *= 0.5) {
    bool moved = true;
    for (int sweep = 0; moved && sweep < k_most_sweeps; ++sweep) {
      moved = false;
      // The whole blink, then each corner alone.
      const auto consider = [&](double start, double down, double flat, double up) {
        for (const double sign : {way, -way}) {
          Ramps one{best.start + sign * start, best.down + sign * down, best.floor + sign * flat, best.up + sign * up,
                    0};
          if (!possible(one, end)) continue;
          const double gain = problem.gain(one);
          if (gain > most) {
            most = gain;
            best = one;
            moved = true;
          }
        }
      };
      consider(1, 0, 0, 0);
      consider(1, -1, 0, 0);
      consider(0, 1, -1, 0);
      consider(0, 0, 1, -1);
      consider(0, 0, 0, 1);
      consider(0, 1, 0, -1);
    }
  }
  return best;
}

Ramps closed_in_a_frame(Ramps ramps) {
  const double deepest = ramps.start + ramps.down + 0.5 * ramps.floor;
  const double frame = std::floor(deepest + 0.5);
  const double apart = deepest - frame;
  constexpr double k_near = 0.25;  // frames: so far it goes all the way, and ever less of it up to half a frame
  const double reach = std::max(0.0, std::abs(apart) - k_near) * 0.5 / (0.5 - k_near);
  const double wanted = apart < 0 ? -reach : reach;
  ramps.start += (wanted - apart) * std::clamp(1 - ramps.floor, 0.0, 1.0);
  return ramps;
}

std::optional<UsualRamps> usual_ramps(std::span<const Ramps> all, double deviation) {
  constexpr std::size_t k_least = 3;
  if (all.size() < k_least) return std::nullopt;
  const auto common = [&](double Ramps::*which, double& usual, double& differs) {
    std::vector<double> values;
    std::vector<double> doubts;
    for (const Ramps& one : all) {
      values.push_back(one.*which);
      constexpr double k_of_a_ramp = 1.5;  // so much more than the tremor of a single frame a ramp's length is in doubt
      doubts.push_back(k_of_a_ramp * deviation * one.down / std::max(one.height, deviation));
    }
    // The mean of those in the middle.
    usual = 0;
    constexpr int k_parts = 20;
    for (int k = 0; k <= k_parts; ++k) usual += quantile(values, 0.2 + 0.6 * k / k_parts) / (k_parts + 1);
    const double seen = spread(values);
    const double doubt = quantile(doubts, 0.5);
    constexpr double k_least_difference = 0.05;  // frames
    differs = std::sqrt(std::max(seen * seen - doubt * doubt, k_least_difference * k_least_difference));
  };
  UsualRamps usual;
  common(&Ramps::down, usual.down, usual.down_differs);
  common(&Ramps::floor, usual.floor, usual.floor_differs);
  common(&Ramps::up, usual.up, usual.up_differs);
  return usual;
}

}  // namespace penpose::animation
