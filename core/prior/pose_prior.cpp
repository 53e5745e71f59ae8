#include "core/prior/pose_prior.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/algebra/cholesky.h"
#include "core/prior/shrinkage.h"

namespace penpose::prior {
namespace {

double range_of(const rig::Parameter& parameter) { return parameter.maximum - parameter.minimum; }

double share_of(const rig::Parameter& parameter, double value) {
  return (value - parameter.minimum) / range_of(parameter);
}

/// A pose that cannot be learned from.
std::optional<base::Error> check(std::span<const rig::Parameter> parameters, std::span<const rig::Pose> keys) {
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const std::string place = "key " + std::to_string(k + 1);
    if (keys[k].size() != parameters.size()) {
      return base::Error{
          "has " + std::to_string(keys[k].size()) + " values for " + std::to_string(parameters.size()) + " parameters",
          place, "give one value a parameter"};
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (std::isfinite(keys[k][i])) continue;
      return base::Error{"the value of \"" + parameters[i].name + "\" is no number", place, "key that pose again"};
    }
  }
  return std::nullopt;
}

std::vector<std::size_t> varied_in(std::span<const rig::Parameter> parameters, std::span<const rig::Pose> keys,
                                   std::span<const std::size_t> used) {
  std::vector<std::size_t> varied;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    double least = keys[used.front()][i];
    double most = least;
    for (const std::size_t k : used) {
      least = std::min(least, keys[k][i]);
      most = std::max(most, keys[k][i]);
    }
    if (most - least > k_least_variation * range_of(parameters[i])) varied.push_back(i);
  }
  return varied;
}

/// tr((X'X)^2), which is tr((XX')^2): of the two products the smaller is made.
double square_of_gram(const std::vector<double>& x, std::size_t n, std::size_t p) {
  const bool by_rows = n <= p;
  const std::size_t size = by_rows ? n : p;
  const std::size_t length = by_rows ? p : n;
  const auto at = [&](std::size_t i, std::size_t k) { return by_rows ? x[i * p + k] : x[k * p + i]; };
  double total = 0;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double product = 0;
      for (std::size_t k = 0; k < length; ++k) product += at(i, k) * at(j, k);
      total += (i == j ? 1 : 2) * product * product;
    }
  }
  return total;
}

/// C_uk C_kk^-1 d for all varied parameters of which `known` (numbers among the varied) are held and differ from their
/// means by d. What it says for known ones has no meaning.
std::optional<std::vector<double>> carried(const PosePrior& prior, std::span<const std::size_t> known,
                                           std::vector<double> d) {
  const std::size_t n = prior.samples;
  const std::size_t p = prior.varied.size();
  const std::size_t k = known.size();
  const double scale = (1 - prior.shrinkage) / static_cast<double>(n);
  const double own = prior.shrinkage * prior.spread;
  const auto x = [&](std::size_t sample, std::size_t j) { return prior.deviations[sample * p + known[j]]; };
  // The lower triangle of scale R R' + own I; R has `rows` rows and `terms` columns.
  const auto products = [&](std::size_t rows, std::size_t terms, const auto& r) {
    std::vector<double> matrix(rows * rows, 0.0);
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = 0;
        for (std::size_t t = 0; t < terms; ++t) sum += r(i, t) * r(j, t);
        matrix[i * rows + j] = scale * sum + (i == j ? own : 0);
      }
    }
    return matrix;
  };
  // How much of each sample goes into the answer: scale X_k (scale X_k'X_k + own I)^-1 d, or what is the same,
  // scale (scale X_k X_k' + own I)^-1 X_k d.
  std::vector<double> weights(n, 0.0);
  if (k <= n) {
    auto matrix = products(k, n, [&](std::size_t i, std::size_t s) { return x(s, i); });
    if (!algebra::factor(matrix.data(), k)) return std::nullopt;
    algebra::solve_factored(matrix.data(), k, d.data());
    for (std::size_t s = 0; s < n; ++s) {
      for (std::size_t j = 0; j < k; ++j) weights[s] += x(s, j) * d[j];
    }
  } else {
    auto matrix = products(n, k, x);
    for (std::size_t s = 0; s < n; ++s) {
      for (std::size_t j = 0; j < k; ++j) weights[s] += x(s, j) * d[j];
    }
    if (!algebra::factor(matrix.data(), n)) return std::nullopt;
    algebra::solve_factored(matrix.data(), n, weights.data());
  }
  std::vector<double> out(p, 0.0);
  for (std::size_t s = 0; s < n; ++s) {
    for (std::size_t i = 0; i < p; ++i) out[i] += prior.deviations[s * p + i] * (scale * weights[s]);
  }
  return out;
}

}  // namespace

std::vector<std::size_t> distinct(std::span<const rig::Pose> keys) {
  std::vector<std::size_t> order(keys.size());
  for (std::size_t k = 0; k < keys.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  order.erase(std::unique(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] == keys[b]; }),
              order.end());
  std::stable_sort(order.begin(), order.end());
  return order;
}

base::Result<PosePrior> learn(std::span<const rig::Parameter> parameters, std::span<const rig::Pose> keys) {
  if (auto error = check(parameters, keys)) return *error;
  std::vector<std::size_t> used = distinct(keys);
  if (used.size() < 2) {
    return base::Error{keys.empty()       ? "no pose is keyed yet"
                       : keys.size() == 1 ? "only one pose is keyed yet"
                                          : "all keys hold one pose",
                       "", "key two different poses or more, from which the rest can be learned"};
  }
  // Sums are made in an order of their own, so that moving keys in time changes no bit.
  std::stable_sort(used.begin(), used.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  PosePrior prior;
  prior.varied = varied_in(parameters, keys, used);
  prior.keys = used.size();
  const std::size_t p = prior.varied.size();
  if (p == 0) {
    return base::Error{"the keys differ in nothing that can be seen", "",
                       "key two different poses or more, from which the rest can be learned"};
  }
  bool rests = false;
  for (const std::size_t k : used) {
    rests = rests || std::all_of(prior.varied.begin(), prior.varied.end(),
                                 [&](std::size_t i) { return keys[k][i] == parameters[i].rest; });
    for (const std::size_t i : prior.varied) prior.deviations.push_back(share_of(parameters[i], keys[k][i]));
  }
  prior.samples = used.size() + (rests ? 0 : 1);
  if (!rests) {
    for (const std::size_t i : prior.varied) {
      prior.deviations.push_back(share_of(parameters[i], parameters[i].rest));
    }
  }
  const auto n = static_cast<double>(prior.samples);
  prior.mean.assign(p, 0.0);
  for (std::size_t s = 0; s < prior.samples; ++s) {
    for (std::size_t i = 0; i < p; ++i) prior.mean[i] += prior.deviations[s * p + i];
  }
  for (double& mean : prior.mean) mean /= n;
  double trace = 0;
  for (std::size_t s = 0; s < prior.samples; ++s) {
    for (std::size_t i = 0; i < p; ++i) {
      double& x = prior.deviations[s * p + i];
      x -= prior.mean[i];
      trace += x * x;
    }
  }
  trace /= n;
  const double square = square_of_gram(prior.deviations, prior.samples, p) / (n * n);
  prior.shrinkage = oracle_shrinkage(prior.samples, p, trace, square);
  prior.spread = trace / static_cast<double>(p);
  return prior;
}

base::Result<rig::Pose> suggest(const PosePrior& prior, std::span<const rig::Parameter> parameters,
                                const rig::Pose& pose, std::span<const std::size_t> held, double strength) {
  std::vector<std::size_t> known;
  std::vector<double> d;
  for (std::size_t i = 0; i < prior.varied.size(); ++i) {
    const std::size_t parameter = prior.varied[i];
    if (!std::binary_search(held.begin(), held.end(), parameter)) continue;
    known.push_back(i);
    d.push_back(share_of(parameters[parameter], pose[parameter]) - prior.mean[i]);
  }
  const auto more = known.empty() ? std::nullopt : carried(prior, known, std::move(d));
  if (!more) {
    return base::Error{"no key moves what is posed now, so that the keys say nothing about the rest", "",
                       "pose something that the keys move, or key this pose as one more"};
  }
  rig::Pose out = pose;
  for (std::size_t i = 0; i < prior.varied.size(); ++i) {
    const std::size_t number = prior.varied[i];
    if (std::binary_search(held.begin(), held.end(), number)) continue;
    const rig::Parameter& parameter = parameters[number];
    const double whole = parameter.minimum + std::clamp(prior.mean[i] + (*more)[i], 0.0, 1.0) * range_of(parameter);
    const double value =
        std::clamp(pose[number] + strength * (whole - pose[number]), parameter.minimum, parameter.maximum);
    if (std::abs(value - pose[number]) >= k_least_change * range_of(parameter)) out[number] = value;
  }
  return out;
}

}  // namespace penpose::prior
