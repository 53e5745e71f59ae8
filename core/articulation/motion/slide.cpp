#include "core/articulation/motion/slide.h"

#include <glm/geometric.hpp>

#include "core/base/math.h"
#include "core/base/sine_cosine.h"
#include "core/geometry/rotation.h"

namespace penpose::articulation {
namespace {

/// Points that go to and fro have no axis in common where less than this share of their ways is left in the sum.
constexpr double k_common = 0.2;

}  // namespace

ModelVector turned_by(const ModelVector& turn, const ModelVector& v) {
  const double angle = geometry::length(turn);
  if (!(angle > 0.0)) return v;
  double sine = 0;
  double cosine = 1;
  base::sine_cosine({&angle, 1}, {&sine, 1}, {&cosine, 1});
  const ModelVector axis = turn / angle;
  const ModelVector along = axis * glm::dot(axis, v);
  return along + (v - along) * cosine + glm::cross(axis, v) * sine;
}

Slide::Slide(const ModelPoint& center, std::span<const ModelPoint> reference, std::span<const ModelPoint> target)
    : center_(center) {
  ModelVector middle{0};
  ModelVector way{0};
  double ways = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    middle += geometry::normalized(reference[i] - center, ModelVector{0});
    way += target[i] - reference[i];
    ways += geometry::distance(target[i], reference[i]);
  }
  const bool common = geometry::length(way) > k_common * ways;
  axis_ = geometry::normalized(common ? glm::cross(middle, way) : ModelVector{0}, ModelVector{0});
  const ModelVector& axis = axis_;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const ModelVector from = reference[i] - center;
    const ModelVector to = target[i] - center;
    const ModelVector a = from - axis * glm::dot(axis, from);
    const ModelVector b = to - axis * glm::dot(axis, to);
    const double across = glm::dot(axis, glm::cross(a, b));
    const double angle = across != 0.0 ? base::atan2(across, glm::dot(a, b)) : 0.0;
    turns_.push_back(axis * angle);
    const geometry::Turn rest = geometry::turn_between(turned_by(turns_.back(), from), to);
    tilts_.push_back(rest.axis * rest.angle);
  }
}

}  // namespace penpose::articulation
