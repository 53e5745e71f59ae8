#include "core/geometry/space.h"

#include <cmath>
#include <glm/common.hpp>

namespace penpose::geometry {

double distance(PxPoint a, PxPoint b) {
  const PxPoint d = a - b;
  return std::sqrt(d.x * d.x + d.y * d.y);
}

double length(const ModelVector& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }
double distance(const ModelPoint& a, const ModelPoint& b) { return length(a - b); }

ModelVector normalized(const ModelVector& v, const ModelVector& fallback) {
  const double size = length(v);
  return size > 1e-300 ? v / size : fallback;
}

void Box::add(const ModelPoint& p) {
  minimum = glm::min(minimum, p);
  maximum = glm::max(maximum, p);
}

double Box::diagonal() const { return empty() ? 0.0 : distance(minimum, maximum); }

}  // namespace penpose::geometry
