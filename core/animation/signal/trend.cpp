#include "core/animation/signal/trend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace penpose::animation {
namespace {

constexpr double k_bend_cost = 4;  // the more, the longer the lines and the more tremor goes
constexpr double k_free_bend = 1;  // bends larger than so many tremors cost less and less
constexpr int k_rounds = 2;
constexpr int k_iterations = 80;  // a round

/// Frames one after the other, `width` numbers each.
struct Table {
  std::size_t width = 0;
  std::vector<double> numbers;

  Table(std::size_t frames, std::size_t w) : width(w), numbers(frames * w, 0.0) {}
  double* row(std::size_t frame) { return &numbers[frame * width]; }
};

/// diag(trust) + stiffness * D^T D with D the second differences, factored as L diag(d) L^T. L has two bands.
class StiffBeam {
 public:
  StiffBeam(std::span<const double> trust, double stiffness) : d_(trust.size()), l1_(trust.size()), l2_(trust.size()) {
    const std::size_t n = trust.size();
    std::vector<double> diagonal(trust.begin(), trust.end());
    std::vector<double> next(n, 0.0);
    for (std::size_t t = 0; t + 2 < n; ++t) {
      diagonal[t] += stiffness;
      diagonal[t + 1] += 4 * stiffness;
      diagonal[t + 2] += stiffness;
      next[t] -= 2 * stiffness;
      next[t + 1] -= 2 * stiffness;
    }
    for (std::size_t t = 0; t < n; ++t) {
      double d = diagonal[t];
      double e = next[t];
      if (t >= 1) {
        d -= l1_[t - 1] * l1_[t - 1] * d_[t - 1];
        e -= l2_[t - 1] * l1_[t - 1] * d_[t - 1];
      }
      if (t >= 2) d -= l2_[t - 2] * l2_[t - 2] * d_[t - 2];
      d_[t] = d;
      l1_[t] = e / d;
      l2_[t] = t + 2 < n ? stiffness / d : 0.0;
    }
  }

  void solve(Table& x) const {
    const std::size_t n = d_.size();
    const auto subtract = [&](std::size_t to, double factor, std::size_t from) {
      double* a = x.row(to);
      const double* b = x.row(from);
      for (std::size_t i = 0; i < x.width; ++i) a[i] -= factor * b[i];
    };
    for (std::size_t t = 1; t < n; ++t) {
      subtract(t, l1_[t - 1], t - 1);
      if (t >= 2) subtract(t, l2_[t - 2], t - 2);
    }
    for (std::size_t t = n; t-- > 0;) {
      double* row = x.row(t);
      for (std::size_t i = 0; i < x.width; ++i) row[i] /= d_[t];
      if (t + 1 < n) subtract(t, l1_[t], t + 1);
      if (t + 2 < n) subtract(t, l2_[t], t + 2);
    }
  }

 private:
  std::vector<double> d_;
  std::vector<double> l1_;
  std::vector<double> l2_;
};

/// Splits `u`, bends and what was left over of them so far, into the bends that are worth their cost and what is left.
void shrink(std::span<const double> cost, double* u, double* bend) {
  for (std::size_t i = 0; i < cost.size(); ++i) {
    const double left = std::min(std::max(u[i], -cost[i]), cost[i]);
    bend[i] = u[i] - left;
    u[i] = left;
  }
}

}  // namespace

void follow_trend(std::span<const double> trust, double tremor, std::vector<std::vector<double>>& rows) {
  const std::size_t n = rows.size();
  if (n < 3 || rows[0].empty() || !(tremor > 0)) return;
  const std::size_t m = rows[0].size();
  // The step of the alternation grows with the cost. The higher it is, the more iterations what shakes from frame to
  // frame takes; a remainder far below the tremor stays.
  constexpr double stiffness = k_bend_cost;
  const StiffBeam beam(trust, stiffness);
  Table x(n, m);
  Table bends(n - 2, m);
  Table dual(n - 2, m);
  // From the rows themselves, so that next to no tremor changes next to nothing; short gaps of
  // little trust are bridged.
  std::vector<double> surely;
  for (const double c : trust) surely.push_back(c * c * c);
  for (std::size_t t = 0; t < n; ++t) {
    for (std::size_t i = 0; i < m; ++i) x.row(t)[i] = surely[t] * rows[t][i];
  }
  StiffBeam(surely, 1e-6).solve(x);
  for (std::size_t t = 0; t + 2 < n; ++t) {
    for (std::size_t i = 0; i < m; ++i) bends.row(t)[i] = x.row(t)[i] - 2 * x.row(t + 1)[i] + x.row(t + 2)[i];
  }
  std::vector<double> cost((n - 2) * m, tremor);  // of every bend
  for (int round = 0; round < k_rounds; ++round) {
    for (int k = 0; k < k_iterations; ++k) {
      for (std::size_t t = 0; t < n; ++t) {
        for (std::size_t i = 0; i < m; ++i) x.row(t)[i] = trust[t] * rows[t][i];
      }
      for (std::size_t t = 0; t + 2 < n; ++t) {
        for (std::size_t i = 0; i < m; ++i) {
          const double v = stiffness * (bends.row(t)[i] - dual.row(t)[i]);
          x.row(t)[i] += v;
          x.row(t + 1)[i] -= 2 * v;
          x.row(t + 2)[i] += v;
        }
      }
      beam.solve(x);
      for (std::size_t t = 0; t + 2 < n; ++t) {
        double* bend = bends.row(t);
        double* u = dual.row(t);
        for (std::size_t i = 0; i < m; ++i) u[i] += x.row(t)[i] - 2 * x.row(t + 1)[i] + x.row(t + 2)[i];
        shrink(std::span(cost).subspan(t * m, m), u, bend);
      }
    }
    // The larger a bend is, the less it costs from now on.
    const double free = k_free_bend * tremor;
    for (std::size_t i = 0; i < cost.size(); ++i) cost[i] = tremor / (1.0 + std::abs(bends.numbers[i]) / free);
  }
  for (std::size_t t = 0; t < n; ++t) rows[t].assign(x.row(t), x.row(t) + m);
}

}  // namespace penpose::animation
