#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/math.h"
#include "core/document/time/overlap.h"

namespace penpose::document {
namespace {

constexpr int k_cells = 96, k_search_halvings = 48;
/// The search begins at springs that are hardly seen to lag.
constexpr double k_least_period_frames = 0.5;
/// The golden section.
constexpr double k_section = 0.6180339887498949;

/// How far off springs are, by their periods.
struct Misses {
  const LedWay& way;
  Spring spring;
  double time_s = 0;
  double value = 0;
  [[nodiscard]] double at(double period_s) const { return way.trailed_at({period_s, spring.swing}, time_s) - value; }
};

double root_between(const Misses& misses, double from, double to, double miss_from) {
  for (int i = 0; i < k_search_halvings; ++i) {
    const double middle = 0.5 * (from + to);
    const double miss = misses.at(middle);
    if (miss == 0) return middle;
    if ((miss < 0) == (miss_from < 0)) {
      from = middle;
    } else {
      to = middle;
    }
  }
  return 0.5 * (from + to);
}

double nearest_between(const Misses& misses, double from, double to) {
  double a = to - k_section * (to - from);
  double b = from + k_section * (to - from);
  double miss_a = std::abs(misses.at(a));
  double miss_b = std::abs(misses.at(b));
  for (int i = 0; i < k_search_halvings; ++i) {
    if (miss_a <= miss_b) {
      to = b;
      b = a;
      miss_b = miss_a;
      a = to - k_section * (to - from);
      miss_a = std::abs(misses.at(a));
    } else {
      from = a;
      a = b;
      miss_a = miss_b;
      b = from + k_section * (to - from);
      miss_b = std::abs(misses.at(b));
    }
  }
  return 0.5 * (from + to);
}

}  // namespace

FoundSpring spring_through(const LedWay& way, const Spring& now, double time_s, double value, int rate) {
  const Misses misses{way, now, time_s, way.in_range(value)};
  const double least_s = k_least_period_frames / rate;
  const double ratio = base::log(k_longest_period_frames / k_least_period_frames) / k_cells;
  std::vector<double> periods{0};
  for (int k = 0; k <= k_cells; ++k) periods.push_back(least_s * base::exp(ratio * k));
  std::vector<double> off;
  for (const double period_s : periods) off.push_back(misses.at(period_s));
  std::vector<double> roots;
  for (std::size_t k = 0; k < periods.size(); ++k) {
    if (off[k] == 0) roots.push_back(periods[k]);
    if (k > 0 && off[k - 1] * off[k] < 0) roots.push_back(root_between(misses, periods[k - 1], periods[k], off[k - 1]));
  }
  const auto away = [&](double period_s) {
    return std::abs(base::log(std::max(period_s, least_s) / std::max(now.period_s, least_s)));
  };
  const auto found = [&](double period_s, bool passes) {
    const Spring spring{period_s, now.swing};
    return FoundSpring{spring, passes, way.trailed_at(spring, time_s)};
  };
  const double off_now = std::abs(misses.at(now.period_s));
  if (off_now == 0) return found(now.period_s, true);
  if (!roots.empty()) {
    return found(*std::min_element(roots.begin(), roots.end(), [&](double a, double b) { return away(a) < away(b); }),
                 true);
  }
  std::size_t best = 0;
  for (std::size_t k = 1; k < periods.size(); ++k) {
    if (std::abs(off[k]) < std::abs(off[best])) best = k;
  }
  const double period_s =
      nearest_between(misses, periods[best > 0 ? best - 1 : 0], periods[std::min(best + 1, periods.size() - 1)]);
  // Where stiffness makes no difference, the spring stays as it is.
  const double least = std::min(std::abs(misses.at(period_s)), std::abs(off[best]));
  if (!(least < off_now * (1 - 1e-9))) return found(now.period_s, false);
  return found(std::abs(misses.at(period_s)) < std::abs(off[best]) ? period_s : periods[best], false);
}

}  // namespace penpose::document
