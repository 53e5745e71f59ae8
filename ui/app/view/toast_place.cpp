#include "ui/app/view/toast_place.h"

#include <algorithm>
#include <array>

#include "core/geometry/camera.h"

namespace penpose::app {
namespace {

/// What comes so close is covered, px.
constexpr double k_margin_px = 8;

std::size_t covered(const Area& area, std::span<const PxPoint> points) {
  const Area wide{area.left - k_margin_px, area.top - k_margin_px, area.right + k_margin_px, area.bottom + k_margin_px};
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [&](const PxPoint& p) { return wide.holds(p); }));
}

}  // namespace

Area toast_place(const Area& inside, double width, double height, std::span<const PxPoint> points) {
  const auto at = [&](double x, double y) { return Area{x, y, x + width, y + height}; };
  const std::array places{
      at(inside.left, inside.bottom - height),
      at(inside.right - width, inside.bottom - height),
      at(inside.left, inside.top),
      at(inside.right - width, inside.top),
  };
  return *std::min_element(places.begin(), places.end(),
                           [&](const Area& a, const Area& b) { return covered(a, points) < covered(b, points); });
}

std::vector<PxPoint> drawn_px(const document::View& view, std::span<const render::CurveDrawing> curves) {
  std::vector<PxPoint> points;
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return points;
  for (const auto& curve : curves) {
    points.insert(points.end(), curve.points_px.begin(), curve.points_px.end());
    if (!curve.points_px.empty()) continue;
    for (const auto& point : curve.points) {
      if (const auto px = camera->project(point)) points.push_back(*px);
    }
  }
  return points;
}

}  // namespace penpose::app
