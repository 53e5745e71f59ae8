#include "core/animation/solve/sparse_fit.h"

#include <algorithm>
#include <cmath>

namespace penpose::animation {
namespace {

/// The least of curvature/2 (u - at)^2 + cost |u - rest| within 0..1.
double shrunk(double at, double rest, double cost, double curvature) {
  const double away = at - rest;
  const double most = cost / curvature;
  const double kept = away > most ? away - most : away < -most ? away + most : 0.0;
  return std::clamp(rest + kept, 0.0, 1.0);
}

}  // namespace

void fit_sparsely(const SparseFit& fit, std::span<double> u, SparseWorkspace& work) {
  constexpr int k_sweeps = 40;
  constexpr double k_settled = 1e-4;
  constexpr double k_round_settled = 3e-4;
  const std::size_t n = u.size();
  const std::size_t length = 2 * fit.points;
  work.residual.assign(fit.at_zero.begin(), fit.at_zero.end());
  for (std::size_t k = 0; k < n; ++k) {
    if (u[k] == 0) continue;
    const double* column = &fit.columns[k * length];
    for (std::size_t i = 0; i < length; ++i) work.residual[i] += u[k] * column[i];
  }
  work.weight.resize(fit.points);
  work.curvature.resize(n);
  for (std::size_t round = 0; round < fit.rounds; ++round) {
    for (std::size_t p = 0; p < fit.points; ++p) {
      const double x = work.residual[2 * p];
      const double y = work.residual[2 * p + 1];
      work.weight[p] = fit.weights[p] / std::sqrt(x * x + y * y + fit.softness * fit.softness);
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double* column = &fit.columns[k * length];
      double sum = 0;
      for (std::size_t p = 0; p < fit.points; ++p) {
        sum += work.weight[p] * (column[2 * p] * column[2 * p] + column[2 * p + 1] * column[2 * p + 1]);
      }
      work.curvature[k] = sum;
    }
    double changed = 0;
    for (int sweep = 0; sweep < k_sweeps; ++sweep) {
      double largest = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const double* column = &fit.columns[k * length];
        const double told = fit.told.empty() ? 0.0 : fit.told[k];
        const double curvature = work.curvature[k] + 2 * (fit.hold + fit.even + told);
        if (!(curvature > 0)) continue;
        double slope = 0;
        for (std::size_t p = 0; p < fit.points; ++p) {
          slope +=
              work.weight[p] * (column[2 * p] * work.residual[2 * p] + column[2 * p + 1] * work.residual[2 * p + 1]);
        }
        slope += 2 * fit.hold * (u[k] - fit.last[k]) + 2 * fit.even * (u[k] - fit.rest[k]);
        if (told > 0) slope += 2 * told * (u[k] - fit.wish[k]);
        const double to = shrunk(u[k] - slope / curvature, fit.rest[k], fit.cost[k], curvature);
        const double step = to - u[k];
        if (step == 0) continue;
        for (std::size_t i = 0; i < length; ++i) work.residual[i] += step * column[i];
        u[k] = to;
        largest = std::max(largest, std::abs(step));
      }
      changed = std::max(changed, largest);
      if (largest < k_settled) break;
    }
    if (changed < k_round_settled) break;
  }
}

std::vector<Twins> find_twins(const SparseFit& fit) {
  constexpr double k_alike = 0.05;
  const std::size_t length = 2 * fit.points;
  std::vector<Twins> twins;
  for (std::size_t a = 0; a < fit.cost.size(); ++a) {
    for (std::size_t b = a + 1; b < fit.cost.size(); ++b) {
      double apart = 0;
      double both = 0;
      for (std::size_t i = 0; i < length; ++i) {
        const double x = fit.columns[a * length + i];
        const double y = fit.columns[b * length + i];
        apart += (x - y) * (x - y);
        both += x * x + y * y;
      }
      const bool same_cost = std::abs(fit.cost[a] - fit.cost[b]) <= k_alike * std::max(fit.cost[a], fit.cost[b]);
      if (same_cost && both > 0 && apart < k_alike * k_alike * both) twins.push_back({a, b});
    }
  }
  return twins;
}

void share_evenly(std::span<const Twins> twins, std::span<double> u) {
  for (const Twins& pair : twins) {
    const double mean = 0.5 * (u[pair.a] + u[pair.b]);
    u[pair.a] = u[pair.b] = mean;
  }
}

}  // namespace penpose::animation
