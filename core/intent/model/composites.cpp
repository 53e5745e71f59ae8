#include "core/intent/model/composites.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::intent {
namespace {

/// A control is a sum of others where they leave less than this share of its squares.
constexpr double k_sum_leaves = 0.012;
constexpr std::size_t k_most_parts = 5;
/// Less of a control than this is no part.
constexpr double k_least_part = 0.05;

/// A few others that do what one control does.
struct Sum {
  std::vector<std::size_t> of;
  std::vector<double> by;
  double leaves = 1;  ///< share of the squares
};

/// Greedy and non-negative; no part beyond its range.
Sum sum_of(const std::vector<double>& gram, std::size_t n, std::size_t j, const std::vector<bool>& atoms) {
  Sum sum;
  const double whole = gram[j * n + j];
  while (sum.of.size() < k_most_parts && sum.leaves > 0.2 * k_sum_leaves) {
    std::size_t best = n;
    double gain = 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == j || !atoms[k] || !(gram[k * n + k] > 0.0)) continue;
      if (std::find(sum.of.begin(), sum.of.end(), k) != sum.of.end()) continue;
      double pull = gram[j * n + k];
      for (std::size_t m = 0; m < sum.of.size(); ++m) pull -= sum.by[m] * gram[sum.of[m] * n + k];
      if (!(pull > 0.0)) continue;
      const double value = std::min(1.0, pull / gram[k * n + k]);
      const double one = value * (2.0 * pull - value * gram[k * n + k]);
      if (one > gain) {
        gain = one;
        best = k;
      }
    }
    if (best == n || gain < 1e-3 * whole) break;
    sum.of.push_back(best);
    sum.by.push_back(0.0);
    for (int sweep = 0; sweep < 30; ++sweep) {
      for (std::size_t m = 0; m < sum.of.size(); ++m) {
        double pull = gram[j * n + sum.of[m]];
        for (std::size_t k = 0; k < sum.of.size(); ++k) {
          if (k != m) pull -= sum.by[k] * gram[sum.of[k] * n + sum.of[m]];
        }
        sum.by[m] = std::clamp(pull / gram[sum.of[m] * n + sum.of[m]], 0.0, 1.0);
      }
    }
    double left = whole;
    for (std::size_t m = 0; m < sum.of.size(); ++m) {
      left -= 2.0 * sum.by[m] * gram[j * n + sum.of[m]];
      for (std::size_t k = 0; k < sum.of.size(); ++k) left += sum.by[m] * sum.by[k] * gram[sum.of[m] * n + sum.of[k]];
    }
    sum.leaves = std::max(0.0, left / whole);
  }
  return sum;
}

}  // namespace

std::vector<Composite> composites_of(const ControlFields& fields, const std::vector<bool>& usable) {
  const std::size_t d = fields.control_count();
  std::vector<Composite> out(d);
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < d; ++i) {
    if (usable[i]) used.push_back(i);
  }
  const std::size_t n = used.size();
  std::vector<double> gram(n * n);
  ControlFields::Spread ways;
  for (std::size_t first = 0; first < n; first += ControlFields::k_together) {
    const std::size_t count = std::min(ControlFields::k_together, n - first);
    fields.spread(std::span(used).subspan(first, count), ways);
    for (std::size_t k = 0; k < first + count; ++k) {
      const auto products = fields.products(ways, used[k]);
      for (std::size_t c = 0; c < count; ++c) gram[(first + c) * n + k] = gram[k * n + first + c] = products[c];
    }
  }
  std::vector<bool> atoms(n, true);
  std::vector<Sum> sums(n);
  for (std::size_t j = 0; j < n; ++j) {
    if (gram[j * n + j] > 0.0) sums[j] = sum_of(gram, n, j, atoms);
  }
  // What is a sum is no part of others; the clearest first.
  for (std::size_t round = 0; round < n; ++round) {
    std::size_t clearest = n;
    for (std::size_t j = 0; j < n; ++j) {
      if (!atoms[j] || sums[j].of.size() < 2 || sums[j].leaves > k_sum_leaves) continue;
      if (clearest == n || sums[j].leaves < sums[clearest].leaves) clearest = j;
    }
    if (clearest == n) break;
    atoms[clearest] = false;
    const Sum& sum = sums[clearest];
    Composite& one = out[used[clearest]];
    double total = 0;
    for (std::size_t m = 0; m < sum.of.size(); ++m) total += sum.by[m] * std::sqrt(gram[sum.of[m] * n + sum.of[m]]);
    double entropy = 0;
    for (std::size_t m = 0; m < sum.of.size(); ++m) {
      const double share = sum.by[m] * std::sqrt(gram[sum.of[m] * n + sum.of[m]]) / total;
      if (share > 0.0) entropy -= share * base::log(share);
      if (sum.by[m] > k_least_part) one.of.push_back(used[sum.of[m]]);
    }
    one.parts = base::exp(entropy);
    for (std::size_t j = 0; j < n; ++j) {
      if (atoms[j] && std::find(sums[j].of.begin(), sums[j].of.end(), clearest) != sums[j].of.end())
        sums[j] = sum_of(gram, n, j, atoms);
    }
  }
  return out;
}

}  // namespace penpose::intent
