#include "ui/render/ghosts/ghost_moments.h"

#include <algorithm>

namespace penpose::render {
namespace {

/// Moments that are nearer to each other are one.
constexpr double k_one_moment_s = 1e-6;

}  // namespace

std::vector<GhostMoment> ghost_moments(const document::Timeline& timeline, double time_s, double rate,
                                       const GhostLook& look) {
  std::vector<GhostMoment> moments;
  if (timeline.keys.empty()) return moments;
  const auto& keys = timeline.keys;
  if (look.steps == GhostSteps::frames) {
    for (int away = -look.before; away <= look.after; ++away) {
      const double at_s = time_s + static_cast<double>(away) * look.every / rate;
      const bool among_keys = at_s > keys.front().time_s - k_one_moment_s && at_s < keys.back().time_s + k_one_moment_s;
      if (away != 0 && among_keys) moments.push_back({at_s, away});
    }
    return moments;
  }
  const auto first = static_cast<int>(document::first_from(timeline, time_s - k_one_moment_s));
  const auto next = static_cast<int>(document::first_from(timeline, time_s + k_one_moment_s));
  const auto count = static_cast<int>(keys.size());
  for (int k = std::max(0, first - look.before); k < first; ++k)
    moments.push_back({keys[static_cast<std::size_t>(k)].time_s, k - first});
  for (int k = next; k < std::min(count, next + look.after); ++k)
    moments.push_back({keys[static_cast<std::size_t>(k)].time_s, k - next + 1});
  return moments;
}

}  // namespace penpose::render
