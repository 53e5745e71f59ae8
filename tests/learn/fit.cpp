#include "tests/learn/fit.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/cholesky.h"
#include "core/base/math.h"

namespace penpose::learn {
namespace {

using inference::k_term_count;
using inference::Terms;

/// The loss of a case, and its first and second derivatives by the weights.
struct Slope {
  double loss = 0;
  std::vector<double> first = std::vector<double>(k_term_count, 0.0);
  std::vector<double> second = std::vector<double>(k_term_count * k_term_count, 0.0);
};

/// Adds log of the sum of exp(-E) over candidates, times `sign`.
double add_log_sum(const LearnCase& one, const Terms& by, bool right_only, double sign, double least, Slope* slope) {
  double sum = 0;
  std::vector<double> mean(k_term_count, 0.0);
  std::vector<double> p(one.candidates.size(), 0.0);
  for (std::size_t i = 0; i < one.candidates.size(); ++i) {
    if (right_only && !one.candidates[i].right) continue;
    p[i] = base::exp(least - by.dot(one.candidates[i].terms));
    sum += p[i];
  }
  if (slope != nullptr) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      p[i] /= sum;
      for (std::size_t k = 0; k < k_term_count; ++k) mean[k] += p[i] * one.candidates[i].terms.values()[k];
    }
    const double by_weight = sign * one.weight;
    for (std::size_t k = 0; k < k_term_count; ++k) slope->first[k] -= by_weight * mean[k];
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p[i] < 1e-12) continue;
      for (std::size_t k = 0; k < k_term_count; ++k) {
        const double off = one.candidates[i].terms.values()[k] - mean[k];
        if (off == 0.0) continue;
        for (std::size_t m = 0; m <= k; ++m)
          slope->second[k * k_term_count + m] += by_weight * p[i] * off * (one.candidates[i].terms.values()[m] - mean[m]);
      }
    }
  }
  return sign * (base::log(sum) - least);
}

double least_energy(const LearnCase& one, const Terms& by, bool right_only) {
  double least = 1e300;
  for (const Candidate& c : one.candidates) {
    if (!right_only || c.right) least = std::min(least, by.dot(c.terms));
  }
  return least;
}

bool tells(const LearnCase& one) {
  const auto right = [](const Candidate& c) { return c.right; };
  return std::any_of(one.candidates.begin(), one.candidates.end(), right) &&
         !std::all_of(one.candidates.begin(), one.candidates.end(), right);
}

double loss_of(const std::vector<LearnCase>& cases, const Terms& by, const Widths& widths, Slope* slope) {
  double loss = 0;
  for (const LearnCase& one : cases) {
    if (!tells(one)) continue;
    loss += one.weight * (add_log_sum(one, by, false, 1.0, least_energy(one, by, false), slope) +
                          add_log_sum(one, by, true, -1.0, least_energy(one, by, true), slope));
  }
  for (std::size_t k = 0; k < k_term_count; ++k) {
    const double width = widths.values()[k];
    if (width == 0.0) continue;
    const double share = by.values()[k] / width;
    loss += 0.5 * share * share;
    if (slope == nullptr) continue;
    slope->first[k] += share / width;
    slope->second[k * k_term_count + k] += 1.0 / (width * width);
  }
  return loss;
}

}  // namespace

Score score(const std::vector<LearnCase>& cases, const Terms& by) {
  Score out;
  for (const LearnCase& one : cases) {
    if (std::none_of(one.candidates.begin(), one.candidates.end(), [](const Candidate& c) { return c.right; })) continue;
    ++out.of;
    out.loss += add_log_sum(one, by, false, 1.0, least_energy(one, by, false), nullptr) +
                add_log_sum(one, by, true, -1.0, least_energy(one, by, true), nullptr);
    out.right += least_energy(one, by, true) <= least_energy(one, by, false) ? 1.0 : 0.0;
  }
  if (out.of > 0) {
    out.loss /= static_cast<double>(out.of);
    out.right /= static_cast<double>(out.of);
  }
  return out;
}

Terms fit(const std::vector<LearnCase>& cases, Terms by, const Widths& widths) {
  constexpr int k_steps = 60;
  double loss = loss_of(cases, by, widths, nullptr);
  double damping = 1e-3;
  for (int step = 0; step < k_steps; ++step) {
    Slope slope;
    loss_of(cases, by, widths, &slope);
    std::vector<std::size_t> free;
    for (std::size_t k = 0; k < k_term_count; ++k) {
      const bool held = by.values()[k] <= 0.0 && slope.first[k] > 0.0;
      if (widths.values()[k] != 0.0 && !held) free.push_back(k);
    }
    const std::size_t n = free.size();
    bool better = false;
    for (int tries = 0; tries < 12 && !better; ++tries) {
      std::vector<double> matrix(n * n), right(n);
      for (std::size_t i = 0; i < n; ++i) {
        right[i] = -slope.first[free[i]];
        for (std::size_t k = 0; k <= i; ++k)
          matrix[i * n + k] = matrix[k * n + i] = slope.second[free[i] * k_term_count + free[k]];
        matrix[i * n + i] = std::max(matrix[i * n + i], 0.0) * (1.0 + damping) + damping;
      }
      if (algebra::factor(matrix.data(), n, 1e-9)) {
        algebra::solve_factored(matrix.data(), n, right.data());
        Terms trial = by;
        for (std::size_t i = 0; i < n; ++i) trial.values()[free[i]] = std::max(0.0, by.values()[free[i]] + right[i]);
        const double there = loss_of(cases, trial, widths, nullptr);
        if (there < loss) {
          better = true;
          const bool settled = loss - there < 1e-6 * loss;
          by = trial;
          loss = there;
          damping = std::max(1e-6, damping * 0.3);
          if (settled) return by;
          continue;
        }
      }
      damping *= 6.0;
    }
    if (!better) break;
  }
  return by;
}

}  // namespace penpose::learn
