#include "core/intent/reading/still_points.h"

#include <algorithm>
#include <cmath>

namespace penpose::intent {
namespace {

/// What lies nearer to what is touched than this share of the curve's length moves along with it.
constexpr double k_gives_way = 0.2;
/// The doubt of where a point stands that nobody touched, as a share of a hand's: of what is seen there is little.
constexpr double k_stands = 0.4;

}  // namespace

std::optional<KnownCurve> still_points(const rig::Rig& rig, const rig::Pose& pose, const DrawnCurve& curve) {
  const std::size_t n = curve.stays.size();
  if (n == 0) return std::nullopt;
  const std::vector<ModelPoint> at = reference_at(rig, pose, curve);
  std::vector<double> along(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) along[i] = along[i - 1] + geometry::distance(at[i - 1], at[i]);
  const double near = k_gives_way * along.back();
  // Where the ends meet, the way round counts as well.
  const bool closed = geometry::distance(at.front(), at.back()) < 0.1 * along.back();
  KnownCurve still;
  for (std::size_t i = 0; i < n; ++i) {
    bool moves_along = !curve.stays[i];
    for (std::size_t k = 0; k < n && !moves_along; ++k) {
      if (curve.stays[k]) continue;
      const double apart = std::abs(along[i] - along[k]);
      moves_along = std::min(apart, closed ? along.back() - apart : apart) < near;
    }
    if (moves_along) continue;
    still.reference.push_back(curve.reference[i]);
    still.target.push_back(at[i]);
  }
  if (still.reference.empty()) return std::nullopt;
  const double depth = std::max(0.0, curve.camera.depth(still.target.front()));
  still.doubt = k_stands * curve.doubt_px * curve.camera.units_per_px(depth);
  if (!(still.doubt > 0.0)) return std::nullopt;
  return still;
}

}  // namespace penpose::intent
