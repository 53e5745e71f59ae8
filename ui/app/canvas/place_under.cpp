#include "ui/app/canvas/place_under.h"

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

/// Of a line, the piece that is pulled: so far to either side of the pen, as a share of its length as it is seen, but
/// at least so many px of a view 1000 px high. The rest goes where that leads it.
constexpr double k_piece = 0.2;
constexpr double k_least_piece_px = 12;

/// A line that can be pulled, and how far it is from the pen, px.
struct Nearest {
  PlaceUnder found;
  double away = 0;
};

/// The points of a line that are near to one of them along it: of what is seen of the line, px.
std::vector<posing::CurvePoint> piece_about(const std::vector<posing::CurvePoint>& points,
                                            const std::vector<PxPoint>& seen, std::size_t middle, double height) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < seen.size(); ++i)
    along.push_back(along.back() + geometry::distance(seen[i - 1], seen[i]));
  const double reach = std::max(k_piece * along.back(), k_least_piece_px * height / 1000.0);
  std::size_t from = middle;
  std::size_t to = middle;
  while (from > 0 && along[middle] - along[from - 1] <= reach) --from;
  while (to + 1 < seen.size() && along[to + 1] - along[middle] <= reach) ++to;
  // A line has two points at least.
  if (from == to && to + 1 < seen.size()) ++to;
  if (from == to && from > 0) --from;
  return {points.begin() + static_cast<std::ptrdiff_t>(from), points.begin() + static_cast<std::ptrdiff_t>(to) + 1};
}

/// What lies under the pen.
struct Pen {
  PxPoint at;
  double near_px = 0;
  double deepest = 0;  ///< what is seen there, and not through it
};

/// Takes a line where it is nearer than what was found before and is not behind the surface under the pen.
void look_at(std::optional<Nearest>& nearest, const portrait::FeatureCurve& curve, const PosedSurface& surface,
             const Camera& camera, const Pen& pen) {
  const std::vector<geometry::ModelPoint> points = feature_points(curve, surface);
  std::vector<PxPoint> seen;
  for (const geometry::ModelPoint& point : points) {
    const auto px = camera.project(point);
    if (!px) return;
    seen.push_back(*px);
  }
  double least = pen.near_px;
  std::optional<std::size_t> place;
  for (std::size_t i = 1; i < seen.size(); ++i) {
    const PxPoint way = seen[i] - seen[i - 1];
    const PxPoint to = pen.at - seen[i - 1];
    const double square = way.x * way.x + way.y * way.y;
    const double share = square > 0 ? std::clamp((to.x * way.x + to.y * way.y) / square, 0.0, 1.0) : 0.0;
    const double away = geometry::distance(seen[i - 1] + way * share, pen.at);
    const std::size_t nearer = share < 0.5 ? i - 1 : i;
    if (away >= least || camera.depth(points[nearer]) > pen.deepest) continue;
    least = away;
    place = nearer;
  }
  if (!place || (nearest && nearest->away <= least)) return;
  nearest =
      Nearest{{{piece_about(curve.points, seen, *place, camera.viewport().height), {pen.at, 0}}, curve.name}, least};
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
  Pen pen{at, near_px, std::numeric_limits<double>::infinity()};
  if (hit) {
    const mesh::Triangle& triangle = surface.model().mesh->triangles()[hit->triangle];
    geometry::ModelPoint there(0);
    for (std::size_t k = 0; k < 3; ++k)
      there += geometry::ModelPoint(surface.positions()[triangle[k]]) * hit->barycentric[k];
    pen.deepest = camera->depth(there) + k_behind * surface.size();
  }
  std::optional<Nearest> nearest;
  const document::FeatureCurves& features = editing.all_features();
  for (const auto* list : {&features.curves, &features.unsure}) {
    for (const portrait::FeatureCurve& curve : *list) look_at(nearest, curve, surface, *camera, pen);
  }
  const document::Document& document = editing.document();
  for (const auto& curve : document.curves) {
    if (curve->role != document::PoseCurveRole::reference || !editing.moments().shows(curve->id)) continue;
    look_at(nearest, {{}, document::curve_points(document, curve->points)}, surface, *camera, pen);
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
