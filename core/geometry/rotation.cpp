#include "core/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"

namespace penpose::geometry {

glm::dmat3 rotation_about(const ModelVector& a, double angle) {
  const double c = base::cos(angle);
  const double s = base::sin(angle);
  const double t = 1.0 - c;
  // GLM's constructor takes columns.
  return {t * a.x * a.x + c,       t * a.x * a.y + s * a.z, t * a.x * a.z - s * a.y,
          t * a.x * a.y - s * a.z, t * a.y * a.y + c,       t * a.y * a.z + s * a.x,
          t * a.x * a.z + s * a.y, t * a.y * a.z - s * a.x, t * a.z * a.z + c};
}

Turn turn_between(const ModelVector& from, const ModelVector& to) {
  const double from_length = length(from);
  const double to_length = length(to);
  if (!(from_length > 0.0) || !(to_length > 0.0)) return {};
  const ModelVector a = from / from_length;
  const ModelVector b = to / to_length;
  const ModelVector axis = glm::cross(a, b);
  const double sine = length(axis);
  const double cosine = glm::dot(a, b);
  if (sine < 1e-12) {
    if (cosine > 0.0) return {};
    const ModelVector least = std::abs(a.x) <= std::abs(a.y) && std::abs(a.x) <= std::abs(a.z) ? ModelVector{1, 0, 0}
                              : std::abs(a.y) <= std::abs(a.z)                                 ? ModelVector{0, 1, 0}
                                                                                               : ModelVector{0, 0, 1};
    return {normalized(glm::cross(a, least)), base::k_pi};
  }
  return {axis / sine, base::atan2(sine, cosine)};
}

glm::dquat quaternion_from_xyz(const glm::dvec3& angles) {
  const glm::dvec3 h = angles * 0.5;
  const glm::dquat qx(base::cos(h.x), base::sin(h.x), 0, 0);
  const glm::dquat qy(base::cos(h.y), 0, base::sin(h.y), 0);
  const glm::dquat qz(base::cos(h.z), 0, 0, base::sin(h.z));
  return qx * qy * qz;
}

glm::dvec3 xyz_from_quaternion(const glm::dquat& q) {
  // Entries of Rx Ry Rz (row, column): r02 = sin y, r12 = -sin x cos y, r22 = cos x cos y, r01 = -cos y sin z, r00 =
  // cos y cos z.
  const double r00 = 1 - 2 * (q.y * q.y + q.z * q.z);
  const double r01 = 2 * (q.x * q.y - q.w * q.z);
  const double r02 = 2 * (q.x * q.z + q.w * q.y);
  const double r12 = 2 * (q.y * q.z - q.w * q.x);
  const double r22 = 1 - 2 * (q.x * q.x + q.y * q.y);
  const double y = base::k_pi / 2 - base::acos(r02);
  if (std::abs(r02) > 1 - 1e-12) {
    // x and z turn about the same axis; all of it is given to x.
    const double r10 = 2 * (q.x * q.y + q.w * q.z);
    const double r11 = 1 - 2 * (q.x * q.x + q.z * q.z);
    return {r02 > 0 ? base::atan2(r10, r11) : -base::atan2(r10, r11), y, 0};
  }
  return {base::atan2(-r12, r22), y, base::atan2(-r01, r00)};
}

glm::dmat4 compose(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale) {
  const double norm =
      std::sqrt(rotation.w * rotation.w + rotation.x * rotation.x + rotation.y * rotation.y + rotation.z * rotation.z);
  const glm::dquat q = norm > 1e-300 ? rotation / norm : glm::dquat(1, 0, 0, 0);
  const glm::dvec3 x{1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)};
  const glm::dvec3 y{2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)};
  const glm::dvec3 z{2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)};
  return {glm::dvec4(x * scale.x, 0), glm::dvec4(y * scale.y, 0), glm::dvec4(z * scale.z, 0),
          glm::dvec4(translation, 1)};
}

}  // namespace penpose::geometry
