#include "tests/learn/fit.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/cholesky.h"
#include "core/base/math.h"

namespace penpose::learn {
namespace {

using inference::k_term_count;
using inference::Terms;

/// So many labels are wrong, as a share: no case, however unlikely, pulls more than that.
constexpr double k_mislabelled = 0.02;

/// The first derivatives of the loss by the weights, and a positive bound of the second.
struct Slope {
  std::vector<double> first = std::vector<double>(k_term_count, 0.0);
  std::vector<double> second = std::vector<double>(k_term_count * k_term_count, 0.0);
};

/// exp(-E) of each candidate, the largest being 1.
std::vector<double> likelihoods(const LearnCase& one, const Terms& by) {
  std::vector<double> p;
  double least = 1e300;
  for (const Candidate& c : one.candidates) {
    p.push_back(by.dot(c.terms));
    least = std::min(least, p.back());
  }
  for (double& value : p) value = base::exp(least - value);
  return p;
}

/// The probability that a right reading is meant.
double probability_of_right(const LearnCase& one, const std::vector<double>& p) {
  double right = 0, sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum += p[i];
    if (one.candidates[i].right) right += p[i];
  }
  return right / sum;
}

double loss_of(const LearnCase& one, const std::vector<double>& p) {
  return -base::log((1.0 - k_mislabelled) * probability_of_right(one, p) + k_mislabelled);
}

void add_slope(const LearnCase& one, const std::vector<double>& p, Slope& slope) {
  const double right = probability_of_right(one, p);
  const double by = one.weight * (1.0 - k_mislabelled) * right / ((1.0 - k_mislabelled) * right + k_mislabelled);
  std::vector<double> all(k_term_count, 0.0), good(k_term_count, 0.0);
  double sum = 0, sum_good = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto terms = one.candidates[i].terms.values();
    sum += p[i];
    if (one.candidates[i].right) sum_good += p[i];
    for (std::size_t k = 0; k < k_term_count; ++k) {
      all[k] += p[i] * terms[k];
      if (one.candidates[i].right) good[k] += p[i] * terms[k];
    }
  }
  for (std::size_t k = 0; k < k_term_count; ++k) {
    all[k] /= sum;
    if (sum_good > 0.0) good[k] /= sum_good;
    slope.first[k] += by * (good[k] - all[k]);
  }
  // Of a difference of two convex functions the one that is subtracted is replaced by its tangent.
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double share = by * p[i] / sum;
    if (share < 1e-9) continue;
    const auto terms = one.candidates[i].terms.values();
    for (std::size_t k = 0; k < k_term_count; ++k) {
      const double off = terms[k] - all[k];
      if (off == 0.0) continue;
      for (std::size_t m = 0; m <= k; ++m) slope.second[k * k_term_count + m] += share * off * (terms[m] - all[m]);
    }
  }
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
    const std::vector<double> p = likelihoods(one, by);
    loss += one.weight * loss_of(one, p);
    if (slope != nullptr) add_slope(one, p, *slope);
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
    if (std::none_of(one.candidates.begin(), one.candidates.end(), [](const Candidate& c) { return c.right; }))
      continue;
    ++out.of;
    const std::vector<double> p = likelihoods(one, by);
    out.loss += loss_of(one, p);
    const auto best = static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin());
    out.right += one.candidates[best].right ? 1.0 : 0.0;
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
