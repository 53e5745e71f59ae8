#include "core/io/fbx/motion/fbx_times.h"

#include <algorithm>
#include <cmath>

namespace penpose::io {
namespace {

/// Keys nearer than this are one.
constexpr double k_same_s = 1e-6;
/// How long before a jump the value before it is kept.
constexpr double k_before_jump_s = 1e-3;

void sort_times(std::vector<double>& times) {
  std::stable_sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < k_same_s; }),
              times.end());
}

}  // namespace

std::optional<FbxTimes> fbx_times(std::span<const FbxCurve* const> curves, bool turn, double rate, const FbxTake& take,
                                  std::size_t most) {
  FbxTimes out;
  std::vector<double>& times = out.times_s;
  std::vector<double> jumps;
  for (const FbxCurve* curve : curves) {
    curve->add_times(times);
    curve->add_jumps(jumps);
    if (curve->goes_on() && take.start_s() < take.stop_s()) {
      times.push_back(take.start_s());
      times.push_back(take.stop_s());
    }
  }
  sort_times(times);
  out.steps = std::all_of(curves.begin(), curves.end(), [](const FbxCurve* curve) { return curve->steps(); });
  if (times.size() > most) return std::nullopt;
  if (out.steps) return out;
  sort_times(jumps);
  std::vector<double> more;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double from = times[i];
    const double to = times[i + 1];
    const bool bends = std::any_of(curves.begin(), curves.end(), [&](const FbxCurve* curve) {
      const FbxCurve::Way way = curve->way_between(from, to);
      return way == FbxCurve::Way::bent || (turn && way == FbxCurve::Way::straight);
    });
    if (!bends) continue;
    const double first = std::floor(from * rate + k_same_s) + 1.0;
    const double last = std::ceil(to * rate - k_same_s) - 1.0;
    if (last - first >= static_cast<double>(most)) return std::nullopt;
    for (double step = first; step <= last; ++step) more.push_back(step / rate);
    if (times.size() + more.size() > most) return std::nullopt;
  }
  for (const double jump : jumps) {
    const auto at = std::lower_bound(times.begin(), times.end(), jump - k_same_s);
    if (at != times.begin() && at != times.end() && *(at - 1) < jump - 2.0 * k_before_jump_s)
      more.push_back(jump - k_before_jump_s);
  }
  times.insert(times.end(), more.begin(), more.end());
  sort_times(times);
  if (times.size() > most) return std::nullopt;
  return out;
}

}  // namespace penpose::io
