#include "core/tracking/head_placement.h"

#include <algorithm>

#include "core/animation/signal/denoise.h"

namespace penpose::tracking {

geometry::ModelPoint head_pivot(const rig::Rig& rig, const animation::TrackSetup& setup,
                                const animation::TrackedAnimation& tracked, const geometry::Camera&) {
  std::vector<geometry::ModelPoint> positions(rig.vertex_count());
  rig.evaluate(setup.rest, positions);
  geometry::ModelPoint sum(0);
  for (const posing::CurvePoint& point : tracked.transfer.points) {
    for (std::size_t k = 0; k < 3; ++k) sum += positions[point.vertex[k]] * point.weight[k];
  }
  return sum / static_cast<double>(tracked.transfer.points.size());
}

std::vector<document::Placement> head_placements(const animation::TrackedAnimation& tracked,
                                                 const geometry::ModelPoint& pivot, const geometry::Camera& camera,
                                                 double smooth_s) {
  std::vector<double> scales = tracked.transfer.scale;
  std::stable_sort(scales.begin(), scales.end());
  const double units_per_px = camera.units_per_px(camera.depth(pivot)) * scales[scales.size() / 2];
  // From axes right, down, away to those of the model.
  const glm::dmat3 to_model(camera.right(), -camera.up(), camera.forward());
  const glm::dmat3 to_picture = glm::transpose(to_model);
  std::vector<std::vector<double>> rows;
  for (const animation::HeadTurn& turn : tracked.still.turns) {
    glm::dquat q = glm::quat_cast(to_model * turn.rotation * to_picture);
    if (!rows.empty()) {
      const auto& last = rows.back();
      if (last[0] * q.w + last[1] * q.x + last[2] * q.y + last[3] * q.z < 0) q = -q;
    }
    const geometry::ModelVector shift =
        to_model * geometry::ModelVector(turn.shift.x * units_per_px, turn.shift.y * units_per_px, 0);
    rows.push_back({q.w, q.x, q.y, q.z, shift.x, shift.y, shift.z, turn.scale});
  }
  animation::smooth_over_time(tracked.times_s, smooth_s, rows);
  std::vector<document::Placement> placements;
  for (const auto& r : rows) {
    placements.push_back({glm::dquat(r[0], r[1], r[2], r[3]), {r[4], r[5], r[6]}, r[7]});
  }
  return placements;
}

}  // namespace penpose::tracking
