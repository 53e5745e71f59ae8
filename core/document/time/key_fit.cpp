#include "core/document/time/key_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/algebra/cholesky.h"

namespace penpose::document {
namespace {

/// The four numbers by which values and slopes of a segment's ends make a value.
std::array<double, 4> hermite_basis(double u, double length_s) {
  const double u2 = u * u;
  const double u3 = u2 * u;
  return {2 * u3 - 3 * u2 + 1, (u3 - 2 * u2 + u) * length_s, 3 * u2 - 2 * u3, (u3 - u2) * length_s};
}

}  // namespace

KeyFit::KeyFit(std::span<const double> moments_s, std::span<const rig::Pose> poses,
               std::span<const std::size_t> controls)
    : moments_s_(moments_s), poses_(poses), controls_(controls), keys_{0, moments_s.size() - 1} {
  fit();
}

std::size_t KeyFit::segment_of(std::size_t pose) const {
  const auto after = std::upper_bound(keys_.begin(), keys_.end() - 1, pose);
  return static_cast<std::size_t>(after - keys_.begin()) - 1;
}

void KeyFit::fit() {
  values_.assign(controls_.size(), std::vector<std::pair<double, double>>(keys_.size()));
  for (std::size_t c = 0; c < controls_.size(); ++c) fit_control(c);
}

void KeyFit::fit_control(std::size_t control) {
  // Unknown: the value and the slope of every key; the values of the first and the last are known.
  const std::size_t n = 2 * keys_.size();
  std::vector<double> matrix(n * n, 0.0);
  std::vector<double> right(n, 0.0);
  const auto value_of = [&](std::size_t pose) { return poses_[pose][controls_[control]]; };
  const double span_s = moments_s_.back() - moments_s_.front();
  for (std::size_t f = 0; f < poses_.size(); ++f) {
    const std::size_t k = segment_of(f);
    const double from_s = moments_s_[keys_[k]];
    const double length_s = moments_s_[keys_[k + 1]] - from_s;
    const auto basis = hermite_basis((moments_s_[f] - from_s) / length_s, length_s);
    for (std::size_t i = 0; i < 4; ++i) {
      right[2 * k + i] += basis[i] * value_of(f);
      for (std::size_t j = 0; j < 4; ++j) matrix[(2 * k + i) * n + 2 * k + j] += basis[i] * basis[j];
    }
  }
  // What no pose says anything about is as between the neighbours.
  constexpr double k_ridge = 1e-9;
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    const std::size_t before = keys_[k == 0 ? 0 : k - 1];
    const std::size_t after = keys_[std::min(k + 1, keys_.size() - 1)];
    const double slope = (value_of(after) - value_of(before)) / (moments_s_[after] - moments_s_[before]);
    matrix[2 * k * n + 2 * k] += k_ridge;
    right[2 * k] += k_ridge * value_of(keys_[k]);
    const double slope_weight = k_ridge * span_s * span_s;
    matrix[(2 * k + 1) * n + 2 * k + 1] += slope_weight;
    right[2 * k + 1] += slope_weight * slope;
  }
  constexpr double k_known = 1e9;
  for (const std::size_t k : {std::size_t{0}, keys_.size() - 1}) {
    matrix[2 * k * n + 2 * k] += k_known;
    right[2 * k] += k_known * value_of(keys_[k]);
  }
  if (!algebra::factor(matrix.data(), n)) return;
  algebra::solve_factored(matrix.data(), n, right.data());
  for (std::size_t k = 0; k < keys_.size(); ++k) values_[control][k] = {right[2 * k], right[2 * k + 1]};
  values_[control].front().first = value_of(keys_.front());
  values_[control].back().first = value_of(keys_.back());
}

rig::Pose KeyFit::fitted(std::size_t pose) const {
  rig::Pose out = poses_[pose];
  const std::size_t k = segment_of(pose);
  const double from_s = moments_s_[keys_[k]];
  const double length_s = moments_s_[keys_[k + 1]] - from_s;
  const auto basis = hermite_basis((moments_s_[pose] - from_s) / length_s, length_s);
  for (std::size_t c = 0; c < controls_.size(); ++c) {
    const auto& [a, slope_a] = values_[c][k];
    const auto& [b, slope_b] = values_[c][k + 1];
    out[controls_[c]] = basis[0] * a + basis[1] * slope_a + basis[2] * b + basis[3] * slope_b;
  }
  return out;
}

void KeyFit::refine(double tolerance, const std::function<std::vector<double>()>& errors) {
  for (;;) {
    const std::vector<double> off = errors();
    const auto worst = std::max_element(off.begin(), off.end());
    if (!(*worst > tolerance) || !add(static_cast<std::size_t>(worst - off.begin()))) return;
  }
}

bool KeyFit::add(std::size_t pose) {
  const auto is_key = [&](std::size_t one) { return std::binary_search(keys_.begin(), keys_.end(), one); };
  const std::size_t k = segment_of(pose);
  std::size_t place = pose;
  // A key that is off needs another one beside it.
  if (is_key(place)) place = (keys_[k] + keys_[k + 1]) / 2;
  if (is_key(place) && k > 0) place = (keys_[k - 1] + keys_[k]) / 2;
  if (is_key(place)) return false;
  keys_.insert(std::upper_bound(keys_.begin(), keys_.end(), place), place);
  fit();
  return true;
}

std::pair<double, double> KeyFit::at(std::size_t control, std::size_t pose) const {
  const auto key = std::lower_bound(keys_.begin(), keys_.end(), pose);
  return values_[control][static_cast<std::size_t>(key - keys_.begin())];
}

}  // namespace penpose::document
