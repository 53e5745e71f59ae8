#include "core/posing/finish.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/algebra/vectors.h"
#include "core/posing/vector_math.h"

namespace penpose::posing {
namespace {

class Finisher {
 public:
  Finisher(const LinearModel& model, std::span<double> u, FinishWorkspace& work)
      : model_(model), u_(u), w_(work), d_(model.variables.count()), m_(model.at_zero.size()) {
    w_.image.resize(m_);
    w_.trial.resize(m_);
    w_.step_image.resize(m_);
    w_.shares.resize(m_);
    w_.scaled.resize(m_);
    w_.hessian.resize(d_ * d_);
    w_.gradient.resize(d_);
    w_.step.resize(d_);
    w_.at.resize(d_);
  }

  FinishResult operator()(const FinishOptions& options) {
    model_.residuals(u_, w_.image);
    value_ = value_at(0.0);
    while (iterations_ < options.max_iterations) {
      ++iterations_;
      reweight();
      build_quadratic();
      descend();
      const double before = value_;
      search_line();
      if (before - value_ <= options.gain_tolerance * value_) break;
    }
    return {value_, iterations_, evaluations_};
  }

 private:
  /// Each point pulls with w / length; points that already fit pull with a large but finite share.
  void reweight() {
    const double mean = value_ / std::max(total_weight(), 1e-300);
    const double shortest = std::max(1e-4 * mean, 1e-300);
    for (std::size_t i = 0; i < model_.weights.size(); ++i) {
      const std::array<std::size_t, 3> at{residual_index(i, 0), residual_index(i, 1), residual_index(i, 2)};
      const double squared =
          w_.image[at[0]] * w_.image[at[0]] + w_.image[at[1]] * w_.image[at[1]] + w_.image[at[2]] * w_.image[at[2]];
      const double length = std::sqrt(squared + model_.softness * model_.softness);
      const double share = model_.weights[i] / std::max(length, shortest);
      for (const std::size_t axis : at) w_.shares[axis] = share;
    }
  }

  [[nodiscard]] double total_weight() const {
    double sum = 0;
    for (const double weight : model_.weights) sum += weight;
    return sum;
  }

  /// The gradient of every variable; the curvature only among those that can move: a variable that stands at an end of
  /// its range and is pushed against it waits for the next iteration.
  void build_quadratic() {
    const double pull = 2.0 * model_.near_weight;
    algebra::multiply(w_.image.data(), w_.shares.data(), w_.scaled.data(), m_);
    w_.active.clear();
    for (std::size_t j = 0; j < d_; ++j) {
      double near = u_[j] - model_.variables.start[j];
      for (const Opposed& pair : model_.variables.opposed) near += pull_between(pair, j);
      const double slope = model_.columns[j].dot(w_.scaled.data()) + pull * near;
      const bool held = (u_[j] <= 0.0 && slope >= 0.0) || (u_[j] >= 1.0 && slope <= 0.0);
      if (held) continue;
      w_.gradient[w_.active.size()] = slope;
      w_.active.push_back(j);
    }
    const std::size_t a = w_.active.size();
    for (std::size_t i = 0; i < a; ++i) {
      const Column& column = model_.columns[w_.active[i]];
      column.multiply(w_.shares.data(), w_.scaled.data());
      for (std::size_t k = i; k < a; ++k) {
        w_.hessian[i * a + k] = w_.hessian[k * a + i] =
            column.dot_within(w_.scaled.data(), model_.columns[w_.active[k]].values().data());
      }
      w_.hessian[i * a + i] += pull;
    }
    for (const Opposed& pair : model_.variables.opposed) {
      const auto first = std::find(w_.active.begin(), w_.active.end(), pair.a);
      const auto second = std::find(w_.active.begin(), w_.active.end(), pair.b);
      if (first == w_.active.end() || second == w_.active.end()) continue;
      const auto i = static_cast<std::size_t>(first - w_.active.begin());
      const auto k = static_cast<std::size_t>(second - w_.active.begin());
      w_.hessian[i * a + k] += pull * share_of(pair);
      w_.hessian[k * a + i] += pull * share_of(pair);
    }
  }

  [[nodiscard]] double share_of(const Opposed& pair) const { return model_.variables.opposed_weight * pair.share; }

  /// How far variable j is pushed by what a pair's other variable does.
  [[nodiscard]] double pull_between(const Opposed& pair, std::size_t j) const {
    if (pair.a != j && pair.b != j) return 0.0;
    const std::size_t other = pair.a == j ? pair.b : pair.a;
    return share_of(pair) * (u_[other] - model_.variables.opposed_from[other]);
  }

  /// Minimises 1/2 s'Hs + g's over u + s within 0..1; leaves s in step.
  void descend() {
    std::fill(w_.step.begin(), w_.step.end(), 0.0);
    const std::size_t a = w_.active.size();
    constexpr int k_max_sweeps = 60;
    for (int sweep = 0; sweep < k_max_sweeps; ++sweep) {
      double largest = 0;
      for (std::size_t i = 0; i < a; ++i) {
        const double curvature = w_.hessian[i * a + i];
        if (!(curvature > 0.0)) continue;
        const std::size_t j = w_.active[i];
        const double to = std::clamp(u_[j] + w_.step[j] - w_.gradient[i] / curvature, 0.0, 1.0) - u_[j];
        const double change = to - w_.step[j];
        if (change == 0.0) continue;
        w_.step[j] = to;
        algebra::add_scaled(change, w_.hessian.data() + i * a, w_.gradient.data(), a);
        largest = std::max(largest, std::abs(change));
      }
      if (largest < 1e-4) break;
    }
  }

  [[nodiscard]] double value_at(double t) {
    ++evaluations_;
    for (std::size_t i = 0; i < m_; ++i) w_.trial[i] = w_.image[i] + t * w_.step_image[i];
    double near = 0;
    for (std::size_t j = 0; j < d_; ++j) {
      w_.at[j] = u_[j] + t * w_.step[j];
      const double d = w_.at[j] - model_.variables.start[j];
      near += d * d;
    }
    near += opposed_term(model_.variables, w_.at);
    return weighted_lengths(w_.trial.data(), model_.weights, model_.softness) + model_.near_weight * near;
  }

  /// The energy along the step is convex: doubles the reach while that gains, then narrows by golden sections.
  void search_line() {
    std::fill(w_.step_image.begin(), w_.step_image.end(), 0.0);
    double limit = 8.0;
    for (std::size_t j = 0; j < d_; ++j) {
      if (w_.step[j] == 0.0) continue;
      model_.columns[j].add_to(w_.step[j], w_.step_image.data());
      limit = std::min(limit, (w_.step[j] > 0.0 ? 1.0 - u_[j] : -u_[j]) / w_.step[j]);
    }
    limit = std::max(limit, 1.0);
    double low = 0;
    double high = limit;
    constexpr double k_golden = 0.61803398874989484820;
    double a = high - k_golden * (high - low);
    double b = low + k_golden * (high - low);
    double at_a = value_at(a);
    double at_b = value_at(b);
    double best = value_;
    double best_t = 0;
    const auto note = [&](double t, double value) {
      if (value < best) {
        best = value;
        best_t = t;
      }
    };
    note(1.0, value_at(1.0));
    note(a, at_a);
    note(b, at_b);
    for (int i = 0; i < 8; ++i) {
      if (at_a <= at_b) {
        high = b;
        b = a;
        at_b = at_a;
        a = high - k_golden * (high - low);
        at_a = value_at(a);
        note(a, at_a);
      } else {
        low = a;
        a = b;
        at_a = at_b;
        b = low + k_golden * (high - low);
        at_b = value_at(b);
        note(b, at_b);
      }
    }
    for (std::size_t j = 0; j < d_; ++j) u_[j] = std::clamp(u_[j] + best_t * w_.step[j], 0.0, 1.0);
    algebra::add_scaled(best_t, w_.step_image.data(), w_.image.data(), m_);
    value_ = best;
  }

  const LinearModel& model_;
  std::span<double> u_;
  FinishWorkspace& w_;
  std::size_t d_;
  std::size_t m_;
  double value_ = 0;
  std::size_t iterations_ = 0;
  std::size_t evaluations_ = 0;
};

}  // namespace

FinishResult finish_linear(const LinearModel& model, const FinishOptions& options, std::span<double> u,
                           FinishWorkspace& work) {
  return Finisher(model, u, work)(options);
}

}  // namespace penpose::posing
