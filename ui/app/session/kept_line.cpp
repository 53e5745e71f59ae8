#include "ui/app/session/kept_line.h"

#include <algorithm>
#include <vector>

#include "core/document/commands/apply.h"

namespace penpose::app {
namespace {

using geometry::PxPoint;

/// From one corner to the other of what is around the points, px.
double extent(std::span<const PxPoint> points) {
  PxPoint low = points.front(), high = low;
  for (const PxPoint& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return geometry::distance(low, high);
}

}  // namespace

double kept_share(const document::Document& document, const document::PoseCurve& curve, const document::View& view,
                  std::span<const curve::StrokeSample> drawn) {
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera || drawn.empty()) return 1;
  const auto positions = document::positions_of(document, curve.points);
  std::vector<PxPoint> seen, line;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto px = camera->project(curve.aside.empty() ? positions[i] : positions[i] + curve.aside[i]);
    if (!px) return 1;
    seen.push_back(*px);
  }
  for (const auto& sample : drawn) line.push_back(sample.position);
  const double whole = extent(line);
  return seen.empty() || !(whole > 0) ? 1 : std::min(1.0, extent(seen) / whole);
}

}  // namespace penpose::app
