#include "core/articulation/region/under_stroke.h"

#include <optional>

namespace penpose::articulation {

using geometry::PxPoint;

std::vector<mesh::Triangle> triangles_under(const Canvas& canvas, const geometry::Camera& camera,
                                            std::span<const PxPoint> stroke, double around) {
  PxBox drawn;
  for (const PxPoint& p : stroke) drawn.add(p);
  drawn.add(drawn.minimum - PxPoint{around, around});
  drawn.add(drawn.maximum + PxPoint{around, around});
  std::vector<std::optional<PxPoint>> seen;
  seen.reserve(canvas.positions().size());
  for (const ModelPoint& p : canvas.positions()) seen.push_back(camera.project(p));
  std::vector<mesh::Triangle> under;
  for (const mesh::Triangle& triangle : canvas.mesh().triangles()) {
    PxBox box;
    bool whole = true;  // a triangle that reaches behind the eye may appear anywhere
    for (const std::uint32_t v : triangle) {
      if (seen[v]) {
        box.add(*seen[v]);
      } else {
        whole = false;
      }
    }
    if (!whole || box.touches(drawn)) under.push_back(triangle);
  }
  return under;
}

}  // namespace penpose::articulation
