#include "ui/app/playback/place_under.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/document/drawing/pose_problem.h"
#include "ui/app/view/shown_features.h"

namespace penpose::app {
namespace {

using geometry::Camera;
using geometry::PxPoint;

/// What lies so much deeper than the surface under the pen is behind it, as a share of the model's size.
constexpr double k_behind = 0.06;
/// The line of the surface that is pulled: points to either side of the pen, and px of a view 1000 px high between
/// them.
constexpr int k_points_aside = 3;
constexpr double k_step_px = 6;

/// A line that can be pulled, and how far it is from the pen, px.
struct Nearest {
  PlaceUnder found;
  double away = 0;
};

/// Takes a line where it is nearer than what was found before and is not behind the surface under the pen.
void look_at(std::optional<Nearest>& nearest, const portrait::FeatureCurve& curve, const std::string& feature,
             const PosedSurface& surface, const Camera& camera, PxPoint at, double deepest, double near_px) {
  const std::vector<geometry::ModelPoint> points = feature_points(curve, surface);
  double least = near_px;
  bool is_near = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto px = camera.project(points[i]);
    const auto before = i > 0 ? camera.project(points[i - 1]) : px;
    if (!px || !before) return;
    // The nearest place of this piece of the line.
    const PxPoint way = *px - *before;
    const PxPoint to = at - *before;
    const double square = way.x * way.x + way.y * way.y;
    const double share = square > 0 ? std::clamp((to.x * way.x + to.y * way.y) / square, 0.0, 1.0) : 0.0;
    const double away = geometry::distance(*before + way * share, at);
    if (away >= least || camera.depth(points[i]) > deepest) continue;
    least = away;
    is_near = true;
  }
  if (!is_near || (nearest && nearest->away <= least)) return;
  nearest = Nearest{{{curve.points, {at, curve::k_usual_reach}}, feature}, least};
}

/// Points of the surface along a line through the pen, as far as they lie on one sheet.
std::vector<posing::CurvePoint> short_line(PosedSurface& surface, const Camera& camera, PxPoint at, PxPoint step) {
  const auto triangles = surface.model().mesh->triangles();
  std::vector<posing::CurvePoint> points;
  const auto middle = surface.pick(camera, at);
  if (!middle) return points;
  const auto add = [&](int number, double& depth) {
    const auto hit = surface.pick(camera, at + step * number);
    if (!hit || std::abs(hit->distance - depth) > 0.5 * k_behind * surface.size()) return false;
    depth = hit->distance;
    const mesh::Triangle& triangle = triangles[hit->triangle];
    points.push_back({{triangle[0], triangle[1], triangle[2]}, hit->barycentric});
    return true;
  };
  double depth = middle->distance;
  for (int i = 0; i >= -k_points_aside && add(i, depth); --i) {
  }
  std::reverse(points.begin(), points.end());
  depth = middle->distance;
  for (int i = 1; i <= k_points_aside && add(i, depth); ++i) {
  }
  return points;
}

}  // namespace

std::optional<PlaceUnder> place_under(const EditingSession& editing, PosedSurface& surface, const document::View& view,
                                      PxPoint at, double near_px) {
  const auto camera = Camera::make(view.camera, view.viewport);
  if (!camera) return std::nullopt;
  const auto hit = surface.pick(*camera, at);
  double deepest = std::numeric_limits<double>::infinity();
  if (hit) {
    const mesh::Triangle& triangle = surface.model().mesh->triangles()[hit->triangle];
    geometry::ModelPoint there(0);
    for (std::size_t k = 0; k < 3; ++k)
      there += geometry::ModelPoint(surface.positions()[triangle[k]]) * hit->barycentric[k];
    deepest = camera->depth(there) + k_behind * surface.size();
  }
  std::optional<Nearest> nearest;
  const document::FeatureCurves& features = editing.all_features();
  for (const auto* list : {&features.curves, &features.unsure}) {
    for (const portrait::FeatureCurve& curve : *list)
      look_at(nearest, curve, curve.name, surface, *camera, at, deepest, near_px);
  }
  const document::Document& document = editing.document();
  for (const auto& curve : document.curves) {
    if (curve->role != document::PoseCurveRole::reference || !editing.moments().shows(curve->id)) continue;
    look_at(nearest, {{}, document::curve_points(document, curve->points)}, {}, surface, *camera, at, deepest,
            near_px);
  }
  if (nearest) return std::move(nearest->found);
  if (!hit) return std::nullopt;
  const double step = k_step_px * view.viewport.height / 1000.0;
  for (const PxPoint way : {PxPoint{step, 0}, PxPoint{0, step}}) {
    // All of so short a line is pulled.
    auto points = short_line(surface, *camera, at, way);
    if (points.size() > k_points_aside) return PlaceUnder{{std::move(points), {at, 0}}, {}};
  }
  return std::nullopt;
}

}  // namespace penpose::app
