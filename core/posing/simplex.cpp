#include "core/posing/simplex.h"

#include <algorithm>
#include <cmath>

namespace penpose::posing {
namespace {

/// One run; holds what its steps share.
class Run {
 public:
  Run(Objective& objective, const SimplexOptions& options, SimplexWorkspace& work)
      : objective_(objective), options_(options), w_(work), d_(objective.dimension()), m_(objective.image_size()) {
    const auto n = static_cast<double>(d_);
    if (options.adaptive && d_ > 1) {
      expansion_ = 1.0 + 2.0 / n;
      contraction_ = 0.75 - 0.5 / n;
      shrink_ = 1.0 - 1.0 / n;
    }
    w_.vertices.resize((d_ + 1) * d_);
    w_.images.resize((d_ + 1) * m_);
    w_.values.resize(d_ + 1);
    w_.vertex_sum.resize(d_);
    w_.image_sum.resize(m_);
    w_.trial.resize(d_);
    w_.second.resize(d_);
    w_.trial_image.resize(m_);
    w_.second_image.resize(m_);
  }

  SimplexResult operator()(std::span<double> u, std::span<double> image) {
    start(u, image);
    sum_up();
    std::size_t since_sum = 0;
    while (left() >= 2) {
      rank();
      if (small_enough()) break;
      const double travelled = step();
      if (exhausted_) break;
      if (options_.travel_tolerance > 0.0 && travelled < options_.travel_tolerance) break;
      // The running sums gather rounding errors; a fresh sum now and then keeps them harmless.
      if (++since_sum >= 4 * d_ + 32) {
        sum_up();
        since_sum = 0;
      }
    }
    rank();
    std::copy_n(vertex(best_).begin(), d_, u.begin());
    objective_.make_image(u, image);
    return {w_.values[best_], evaluations_};
  }

 private:
  std::span<double> vertex(std::size_t i) { return std::span(w_.vertices).subspan(i * d_, d_); }
  std::span<double> image(std::size_t i) { return std::span(w_.images).subspan(i * m_, m_); }

  [[nodiscard]] std::size_t left() const {
    return options_.max_evaluations - std::min(options_.max_evaluations, evaluations_);
  }

  double evaluate(std::span<const double> u, std::span<const double> im) {
    ++evaluations_;
    return objective_.value(u, im);
  }

  void start(std::span<const double> u, std::span<const double> im) {
    for (std::size_t k = 0; k <= d_; ++k) {
      std::copy(u.begin(), u.end(), vertex(k).begin());
      std::copy(im.begin(), im.end(), image(k).begin());
      if (k > 0) {
        const double step = u[k - 1] <= 0.5 ? options_.step : -options_.step;
        vertex(k)[k - 1] += step;
        objective_.shift_image(k - 1, step, image(k));
      }
      w_.values[k] = evaluate(vertex(k), image(k));
    }
  }

  void sum_up() {
    std::fill(w_.vertex_sum.begin(), w_.vertex_sum.end(), 0.0);
    std::fill(w_.image_sum.begin(), w_.image_sum.end(), 0.0);
    for (std::size_t k = 0; k <= d_; ++k) {
      for (std::size_t i = 0; i < d_; ++i) w_.vertex_sum[i] += w_.vertices[k * d_ + i];
      for (std::size_t i = 0; i < m_; ++i) w_.image_sum[i] += w_.images[k * m_ + i];
    }
  }

  /// Finds the best, worst and second worst vertex; of equals the first.
  void rank() {
    best_ = worst_ = 0;
    for (std::size_t k = 1; k <= d_; ++k) {
      if (w_.values[k] < w_.values[best_]) best_ = k;
      if (w_.values[k] > w_.values[worst_]) worst_ = k;
    }
    second_worst_ = worst_ == 0 ? 1 : 0;
    for (std::size_t k = 0; k <= d_; ++k) {
      if (k != worst_ && w_.values[k] > w_.values[second_worst_]) second_worst_ = k;
    }
  }

  bool small_enough() {
    const double spread = w_.values[worst_] - w_.values[best_];
    if (spread > options_.value_tolerance * std::abs(w_.values[best_]) + 1e-300) return false;
    for (std::size_t k = 0; k <= d_; ++k) {
      for (std::size_t i = 0; i < d_; ++i) {
        if (std::abs(w_.vertices[k * d_ + i] - w_.vertices[best_ * d_ + i]) > options_.size_tolerance) return false;
      }
    }
    return true;
  }

  /// Puts (1 + t) centroid - t worst into the trial, clamped to the box, and returns its value. The centroid is of all
  /// but the worst.
  double attempt(double t, std::vector<double>& u, std::vector<double>& im) {
    const double share = (1.0 + t) / static_cast<double>(d_);
    const double back = share + t;
    const double* worst_image = w_.images.data() + worst_ * m_;
    const double* sum = w_.image_sum.data();
    double* out = im.data();
    for (std::size_t i = 0; i < m_; ++i) out[i] = share * sum[i] - back * worst_image[i];
    for (std::size_t i = 0; i < d_; ++i) {
      const double wanted = share * w_.vertex_sum[i] - back * w_.vertices[worst_ * d_ + i];
      u[i] = std::clamp(wanted, 0.0, 1.0);
      if (u[i] != wanted) objective_.shift_image(i, u[i] - wanted, im);
    }
    return evaluate(u, im);
  }

  /// Replaces the worst vertex and returns how far it travelled, as a share of the size of where it went.
  double replace(const std::vector<double>& u, const std::vector<double>& im, double value) {
    double moved = 0;
    double size = 0;
    for (std::size_t i = 0; i < d_; ++i) {
      double& old = w_.vertices[worst_ * d_ + i];
      moved += (u[i] - old) * (u[i] - old);
      size += u[i] * u[i];
      w_.vertex_sum[i] += u[i] - old;
      old = u[i];
    }
    for (std::size_t i = 0; i < m_; ++i) {
      double& old = w_.images[worst_ * m_ + i];
      w_.image_sum[i] += im[i] - old;
      old = im[i];
    }
    w_.values[worst_] = value;
    return std::sqrt(moved) / std::max(std::sqrt(size), 1e-3);
  }

  double step() {
    const double reflected = attempt(1.0, w_.trial, w_.trial_image);
    if (reflected < w_.values[best_]) {
      const double expanded = attempt(expansion_, w_.second, w_.second_image);
      return expanded < reflected ? replace(w_.second, w_.second_image, expanded)
                                  : replace(w_.trial, w_.trial_image, reflected);
    }
    if (reflected < w_.values[second_worst_]) return replace(w_.trial, w_.trial_image, reflected);
    const bool outside = reflected < w_.values[worst_];
    const double contracted = attempt(outside ? contraction_ : -contraction_, w_.second, w_.second_image);
    if (contracted < std::min(reflected, w_.values[worst_])) return replace(w_.second, w_.second_image, contracted);
    if (left() < d_) {
      exhausted_ = true;
      return 0;
    }
    return shrink();
  }

  double shrink() {
    double moved = 0;
    for (std::size_t k = 0; k <= d_; ++k) {
      if (k == best_) continue;
      for (std::size_t i = 0; i < d_; ++i) {
        double& x = w_.vertices[k * d_ + i];
        const double to = w_.vertices[best_ * d_ + i] + shrink_ * (x - w_.vertices[best_ * d_ + i]);
        moved = std::max(moved, std::abs(to - x));
        x = to;
      }
      for (std::size_t i = 0; i < m_; ++i) {
        double& x = w_.images[k * m_ + i];
        x = w_.images[best_ * m_ + i] + shrink_ * (x - w_.images[best_ * m_ + i]);
      }
      w_.values[k] = evaluate(vertex(k), image(k));
    }
    sum_up();
    return moved;
  }

  Objective& objective_;
  const SimplexOptions& options_;
  SimplexWorkspace& w_;
  std::size_t d_;
  std::size_t m_;
  double expansion_ = 2.0;
  double contraction_ = 0.5;
  double shrink_ = 0.5;
  std::size_t best_ = 0;
  std::size_t worst_ = 0;
  std::size_t second_worst_ = 0;
  std::size_t evaluations_ = 0;
  bool exhausted_ = false;  ///< a shrink would take more evaluations than are left
};

}  // namespace

SimplexResult run_simplex(Objective& objective, const SimplexOptions& options, std::span<double> u,
                          std::span<double> image, SimplexWorkspace& work) {
  if (objective.dimension() == 0) return {objective.value(u, image), 1};
  return Run(objective, options, work)(u, image);
}

}  // namespace penpose::posing
