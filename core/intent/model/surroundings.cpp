#include "core/intent/model/surroundings.h"

#include <algorithm>
#include <cmath>

namespace penpose::intent {

using geometry::ModelPoint;

namespace {

/// distance(p, q) <= reach, without the root where rounding cannot decide.
bool within(const ModelPoint& p, const ModelPoint& q, double reach) {
  constexpr double k_clear = 1e-12;
  const double square = square_of(p - q);
  if (square > reach * reach * (1.0 + k_clear)) return false;
  return square < reach * reach * (1.0 - k_clear) || std::sqrt(square) <= reach;
}

}  // namespace

Surroundings::Surroundings(std::vector<ModelPoint> rest, std::vector<std::uint32_t> pieces)
    : rest_(std::move(rest)), pieces_(std::move(pieces)) {
  for (std::uint32_t v = 0; v < rest_.size(); ++v) {
    if (std::isfinite(rest_[v].x + rest_[v].y + rest_[v].z)) by_x_.push_back(v);
  }
  std::stable_sort(by_x_.begin(), by_x_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return rest_[a].x < rest_[b].x; });
  ordered_.reserve(by_x_.size());
  for (const std::uint32_t v : by_x_) ordered_.push_back(rest_[v]);
}

std::vector<std::uint32_t> Surroundings::near(std::span<const ModelPoint> places, double reach, std::size_t most,
                                              std::span<const std::uint32_t> pieces) const {
  geometry::Box box;
  for (const ModelPoint& p : places) box.add(p);
  std::vector<std::uint32_t> found;
  if (box.empty()) return found;
  const auto first = std::lower_bound(ordered_.begin(), ordered_.end(), box.minimum.x - reach,
                                      [](const ModelPoint& p, double x) { return p.x < x; });
  for (auto at = first; at != ordered_.end() && at->x <= box.maximum.x + reach; ++at) {
    const ModelPoint& p = *at;
    if (p.y < box.minimum.y - reach || p.y > box.maximum.y + reach) continue;
    if (p.z < box.minimum.z - reach || p.z > box.maximum.z + reach) continue;
    const std::uint32_t v = by_x_[static_cast<std::size_t>(at - ordered_.begin())];
    if (!pieces.empty() && !std::binary_search(pieces.begin(), pieces.end(), piece(v))) continue;
    if (std::any_of(places.begin(), places.end(), [&](const ModelPoint& q) { return within(p, q, reach); }))
      found.push_back(v);
  }
  std::stable_sort(found.begin(), found.end());
  if (found.size() <= most) return found;
  std::vector<std::uint32_t> fewer(most);
  for (std::size_t i = 0; i < most; ++i) fewer[i] = found[i * found.size() / most];
  return fewer;
}

}  // namespace penpose::intent
