#include "core/portrait/reading/sparse_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/algebra/cholesky.h"
#include "core/algebra/vectors.h"
#include "core/base/math.h"

namespace penpose::portrait {
namespace {

/// nu of the energy.
constexpr double k_sparse_reach = 80.0;
/// What a unit costs that moves.
constexpr double k_unit = 6.0, k_alone = 1.0;
/// Times the square of a share.
constexpr double k_share = 3.0;
constexpr std::size_t k_most_units = 14;
constexpr double k_gain = 1e-9;

}  // namespace

double SquaresOfDoubt::curvature(std::size_t i, std::size_t j) const {
  double sum = 0;
  for (const Part& part : parts) {
    sum += part.weight * (algebra::dot(part.columns + i * k_numbers, part.columns + j * k_numbers, k_numbers) -
                          algebra::dot_in_order(part.slid + i * slides, part.slid + j * slides, slides));
  }
  for (const double* row = nuisances.data(); row != nuisances.data() + nuisances.size(); row += width)
    sum -= row[i] * row[j];
  return sum;
}

double SparseSolver::energy_of(double squares) {
  return k_sparse_reach * base::log(1.0 + std::max(0.0, squares) / k_sparse_reach);
}

SparseSolver::SparseSolver(const FaceView& face) : face_(face), count_(face.units().size()) {
  for (const Unit& unit : face.units()) {
    double low = -1e300, high = 1e300;
    for (std::size_t m = 0; m < unit.count; ++m) {
      low = std::max(low, face.controls()[unit.members[m]].low);
      high = std::min(high, face.controls()[unit.members[m]].high);
    }
    low_.push_back(low);
    high_.push_back(high);
    costs_.push_back(k_unit + (unit.one_side ? k_alone : 0.0));
    all_.push_back(all_.size());
  }
}

SparsePose SparseSolver::still(const SquaresOfDoubt& squares) const {
  return {{}, std::vector<double>(face_.controls().size(), 0.0), squares.constant, energy_of(squares.constant)};
}

SparseSolver::Trial SparseSolver::fit(std::vector<std::size_t> units) {
  Trial trial;
  const std::size_t n = units.size();
  std::vector<double> a(n * n), b(n), factor;
  for (std::size_t i = 0; i < n; ++i) {
    b[i] = pull_[units[i]];
    for (std::size_t k = 0; k < n; ++k) a[i * n + k] = curvature(units[i], units[k]);
  }
  trial.values = b;
  factor = a;
  bool inside = algebra::factor(factor.data(), n, 1e-12);
  if (inside) algebra::solve_factored(factor.data(), n, trial.values.data());
  for (std::size_t i = 0; i < n; ++i) {
    const double within = inside ? std::clamp(trial.values[i], low_[units[i]], high_[units[i]]) : 0.0;
    inside = inside && within == trial.values[i];
    trial.values[i] = within;
  }
  for (int round = 0; round < 60 && !inside; ++round) {
    double most = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double left = b[i];
      for (std::size_t k = 0; k < n; ++k) left -= a[i * n + k] * trial.values[k];
      if (!(a[i * n + i] > 0.0)) continue;
      const double there = std::clamp(trial.values[i] + left / a[i * n + i], low_[units[i]], high_[units[i]]);
      most = std::max(most, std::abs(there - trial.values[i]));
      trial.values[i] = there;
    }
    inside = most < 1e-6;
  }
  trial.squares = constant_;
  trial.energy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double row = -2.0 * b[i];
    for (std::size_t k = 0; k < n; ++k) row += a[i * n + k] * trial.values[k];
    trial.squares += trial.values[i] * row;
    trial.energy += costs_[units[i]];
  }
  trial.energy += energy_of(trial.squares);
  trial.units = std::move(units);
  return trial;
}

std::vector<std::size_t> SparseSolver::promising(const Trial& trial, std::size_t count) {
  struct Gain {
    double gain;
    std::size_t unit;
  };
  std::vector<Gain> gains;
  for (std::size_t u = 0; u < count_; ++u) {
    if (std::binary_search(trial.units.begin(), trial.units.end(), u)) continue;
    double left = pull_[u];
    for (std::size_t i = 0; i < trial.units.size(); ++i) left -= curvature(u, trial.units[i]) * trial.values[i];
    const double own = curvature(u, u);
    if (!(own > 0.0)) continue;
    const double value = std::clamp(left / own, low_[u], high_[u]);
    const double gain = 2.0 * left * value - own * value * value;
    if (gain > 0.0) gains.push_back({gain, u});
  }
  std::stable_sort(gains.begin(), gains.end(), [](const Gain& a, const Gain& b) { return a.gain > b.gain; });
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < std::min(count, gains.size()); ++i) out.push_back(gains[i].unit);
  return out;
}

void SparseSolver::set_up(const SquaresOfDoubt& squares, std::span<const std::size_t> only) {
  const auto units = face_.units();
  squares_ = &squares;
  constant_ = squares.constant;
  pull_.resize(count_);
  curvature_.assign(count_ * count_, std::numeric_limits<double>::quiet_NaN());
  for (const std::size_t a : only) {
    pull_[a] = 0;
    for (std::size_t m = 0; m < units[a].count; ++m) pull_[a] += squares.pull[units[a].members[m]];
  }
}

double SparseSolver::curvature(std::size_t a, std::size_t b) {
  if (a < b) std::swap(a, b);
  double& kept = curvature_[a * count_ + b];
  if (!std::isnan(kept)) return kept;
  const Unit &one = face_.units()[a], &other = face_.units()[b];
  double sum = 0;
  for (std::size_t m = 0; m < one.count; ++m) {
    for (std::size_t k = 0; k < other.count; ++k) {
      const std::size_t i = one.members[m], j = other.members[k];
      sum += squares_->curvature(i, j) + (i == j ? k_share : 0.0);
    }
  }
  return kept = sum;
}

double SparseSolver::energy_with(const SquaresOfDoubt& squares, std::span<const std::size_t> units) {
  set_up(squares, units);
  return fit({units.begin(), units.end()}).energy;
}

SparsePose SparseSolver::solve(const SquaresOfDoubt& squares, std::span<const std::size_t> from) {
  const std::size_t controls = face_.controls().size();
  const auto units = face_.units();
  set_up(squares, all_);
  Trial best = fit({from.begin(), from.end()});
  const auto with = [](std::vector<std::size_t> list, std::size_t unit) {
    list.insert(std::upper_bound(list.begin(), list.end(), unit), unit);
    return list;
  };
  const auto without = [](std::vector<std::size_t> list, std::size_t i) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    return list;
  };
  for (int step = 0; step < 60; ++step) {
    Trial next = best;
    const auto consider = [&](Trial trial) {
      if (trial.energy < next.energy - k_gain) next = std::move(trial);
    };
    if (best.units.size() < k_most_units) {
      for (const std::size_t u : promising(best, 10)) consider(fit(with(best.units, u)));
    }
    for (std::size_t i = 0; i < best.units.size(); ++i) consider(fit(without(best.units, i)));
    if (!(next.energy < best.energy - k_gain)) {
      for (std::size_t i = 0; i < best.units.size(); ++i) {
        const Trial less = fit(without(best.units, i));
        for (const std::size_t u : promising(less, 8)) consider(fit(with(less.units, u)));
      }
    }
    if (!(next.energy < best.energy - k_gain)) break;
    best = std::move(next);
  }
  SparsePose pose{best.units, std::vector<double>(controls, 0.0), best.squares, best.energy};
  for (std::size_t i = 0; i < best.units.size(); ++i) {
    const Unit& unit = units[best.units[i]];
    for (std::size_t m = 0; m < unit.count; ++m) pose.shares[unit.members[m]] += best.values[i];
  }
  for (std::size_t j = 0; j < controls; ++j)
    pose.shares[j] = std::clamp(pose.shares[j], face_.controls()[j].low, face_.controls()[j].high);
  return pose;
}

}  // namespace penpose::portrait
