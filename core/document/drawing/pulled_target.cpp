#include "core/document/drawing/pulled_target.h"

#include <cmath>

#include "core/curve/bend.h"
#include "core/curve/pairing.h"
#include "core/curve/polyline.h"
#include "core/geometry/lasso.h"

namespace penpose::document {

base::Result<DrawnTarget> pulled_target(const DrawnTarget& before, const PullTarget& pull) {
  for (const double number : {pull.at.x, pull.at.y, pull.by.x, pull.by.y}) {
    if (std::abs(number) <= geometry::k_largest_px) continue;
    return base::Error{"the target cannot go that far", "by", "pull it by at most a million px"};
  }
  if (!(pull.reach >= 0.0 && pull.reach <= 10.0)) {
    return base::Error{"the reach is no share of the line's length", "reach", "give 0 to 10; 0 takes the whole line"};
  }
  const auto camera = geometry::Camera::make(pull.view.camera, pull.view.viewport);
  if (!camera) return camera.error();
  std::vector<curve::PxPoint> seen;
  for (const geometry::ModelPoint& point : before.points) {
    const auto px = camera->project(point);
    if (!px) return base::Error{"the target lies behind the camera", "view", "look at it and pull again"};
    seen.push_back(*px);
  }
  const bool closed = curve::is_closed(seen, curve::pairing_distance_px(pull.view.viewport));
  const auto weights = curve::pull_weights(seen, curve::nearest_along(seen, pull.at), pull.reach, closed);
  DrawnTarget target = before;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (weights[i] == 0.0) continue;
    const double unit = camera->units_per_px(camera->depth(before.points[i]));
    const curve::PxPoint by = pull.by * weights[i];
    target.points[i] += camera->right() * (by.x * unit) - camera->up() * (by.y * unit);
  }
  // The line that is shown is that of its own view; in another one it is led through the points.
  const std::vector<curve::PxPoint> line = target.view == pull.view ? target.line : seen;
  auto shown = curve::bent(line, pull.at, pull.by, pull.reach, closed);
  auto even = shown ? curve::resample<curve::PxPoint>(*shown, k_line_points) : base::Error{};
  if (!even) return base::Error{"the target has no length in this view", "view", "turn the view so that it is visible"};
  target.line = std::move(*even);
  target.view = pull.view;
  return target;
}

}  // namespace penpose::document
