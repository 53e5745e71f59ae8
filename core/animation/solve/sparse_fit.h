#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace penpose::animation {

/// A pose as a sum of few controls. Minimises, over u within 0..1,
///
///   sum_i w_i phi(|r_i(u)|)  +  sum_k (cost_k |u_k - rest_k| + even (u_k - rest_k)^2 + hold (u_k - last_k)^2 + told_k
///   (u_k - wish_k)^2)
///
/// where r_i are the points' displacements from their targets, linear in u, and phi(r) = sqrt(r^2 + softness^2), a
/// square for short ones and a length for long ones. The costs are not squared, so that controls of little use stay
/// exactly at rest. Convex. Iteratively reweighted least squares outside, coordinate descent inside, starting from the
/// given u; stops count steps, not time.
struct SparseFit {
  std::size_t points = 0;
  std::vector<double> columns;  ///< two numbers a point, one run of them for each control: how it moves the points
  std::vector<double> at_zero;  ///< two numbers a point: displacements to the targets at u = 0, negated
  std::vector<double> weights;  ///< one a point
  std::vector<double> cost;     ///< one a control, as the others below
  std::vector<double> rest;
  std::vector<double> last;
  std::vector<double> told;  ///< or empty
  std::vector<double> wish;
  double hold = 0;
  double even = 0;
  double softness = 0;
  std::size_t rounds = 6;
};

/// Two controls that move all points alike at the same cost, so that either would do.
struct Twins {
  std::size_t a = 0;
  std::size_t b = 0;
};
[[nodiscard]] std::vector<Twins> find_twins(const SparseFit& fit);
/// Gives twins the same value; the points stay where they are.
void share_evenly(std::span<const Twins> twins, std::span<double> u);

struct SparseWorkspace {
  std::vector<double> residual, weight, curvature;
};

void fit_sparsely(const SparseFit& fit, std::span<double> u, SparseWorkspace& work);

}  // namespace penpose::animation
