#include "core/geometry/space.h"

#include <glm/common.hpp>

namespace penpose::geometry {

void Box::add(const ModelPoint& p) {
  minimum = glm::min(minimum, p);
  maximum = glm::max(maximum, p);
}

double Box::diagonal() const { return empty() ? 0.0 : distance(minimum, maximum); }

}  // namespace penpose::geometry
