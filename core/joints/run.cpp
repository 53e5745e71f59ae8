#include "core/joints/run.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace penpose::joints {
namespace {

/// Longer ways are cut into this many parts, at which runs begin and end.
constexpr std::size_t k_parts = 12;
/// Runs that point more than this towards the eye or away from it do not bend within the picture (sine).
constexpr double k_least_seen = 0.3;

bool in(std::span<const std::size_t> chain, std::size_t joint) {
  return std::binary_search(chain.begin(), chain.end(), joint);
}

std::vector<std::size_t> in_chain(const Body& body, std::span<const std::size_t> chain, std::size_t joint) {
  std::vector<std::size_t> out;
  for (const std::size_t one : body.branches(joint))
    if (in(chain, one)) out.push_back(one);
  return out;
}

Run make_run(std::span<const Place> start, std::span<const std::size_t> joints, const ModelVector& along,
             const std::optional<ModelVector>& view) {
  Run run;
  run.joints.assign(joints.begin(), joints.end());
  const ModelVector way = start[joints.back()].at - start[joints.front()].at;
  const ModelVector bone = geometry::length(way) > 0.0 ? geometry::normalized(way) : along;
  const ModelVector least = std::abs(bone.x) <= std::abs(bone.y) && std::abs(bone.x) <= std::abs(bone.z)
                                ? ModelVector{1, 0, 0}
                            : std::abs(bone.y) <= std::abs(bone.z) ? ModelVector{0, 1, 0}
                                                                   : ModelVector{0, 0, 1};
  const ModelVector first = geometry::normalized(glm::cross(bone, least));
  run.axes = glm::dmat3(first, glm::cross(bone, first), bone);
  if (view) {
    const ModelVector out = glm::cross(bone, *view);
    run.planar = geometry::length(out) > k_least_seen;
    run.across = std::max(0.0, 1.0 - 2.0 * std::abs(glm::dot(bone, *view)));
    if (run.planar) run.axes = glm::dmat3(*view, geometry::normalized(out), bone);
  }
  return run;
}

}  // namespace

std::vector<Run> runs_of(const Body& body, std::span<const Place> start, std::span<const std::size_t> chain,
                         const std::optional<ModelVector>& view) {
  std::vector<Run> runs;
  for (const std::size_t top : chain) {
    const std::int32_t parent = body.parent(top);
    const bool first = parent < 0 || !in(chain, static_cast<std::size_t>(parent));
    if (!first && in_chain(body, chain, static_cast<std::size_t>(parent)).size() == 1) continue;
    std::vector<std::size_t> way{top};
    for (auto next = in_chain(body, chain, top); next.size() == 1; next = in_chain(body, chain, next.front()))
      way.push_back(next.front());
    if (body.branches(top).size() > 1) way.erase(way.begin());
    // Elbows and knees bend by themselves.
    if (std::any_of(way.begin(), way.end(), [&](std::size_t joint) { return body.hinge(joint).has_value(); })) continue;
    const std::size_t n = way.size();
    const std::size_t step = (n + k_parts - 1) / k_parts;
    for (std::size_t count = 2; count <= n; ++count) {
      for (std::size_t from = 0; from + count <= n; ++from) {
        const bool begins = from % step == 0;
        const bool ends = (from + count) % step == 0 || from + count == n;
        if (!begins || !ends) continue;
        runs.push_back(make_run(start, std::span(way).subspan(from, count), body.bone(way[from], chain), view));
      }
    }
  }
  return runs;
}

}  // namespace penpose::joints
