#include "core/geometry/placement.h"

#include "core/base/math.h"

namespace penpose::geometry {

ModelVector turned(const Placement& placement, const ModelVector& direction) {
  const double angle = base::radians(placement.turn_degrees);
  const double c = base::cos(angle);
  const double s = base::sin(angle);
  return {c * direction.x + s * direction.z, direction.y, c * direction.z - s * direction.x};
}

ModelPoint placed(const Placement& placement, const ModelPoint& point) {
  return placement.at + turned(placement, point * placement.scale);
}

CameraPose placed(const Placement& placement, const CameraPose& camera) {
  return {placed(placement, camera.eye), placed(placement, camera.look_at), turned(placement, camera.up),
          camera.vertical_fov_degrees};
}

Placement inverse(const Placement& placement) {
  Placement back{{}, -placement.turn_degrees, 1 / placement.scale};
  back.at = turned(back, placement.at) * -back.scale;
  return back;
}

Placement joined(const Placement& first, const Placement& then) {
  return {placed(then, first.at), first.turn_degrees + then.turn_degrees, first.scale * then.scale};
}

}  // namespace penpose::geometry
