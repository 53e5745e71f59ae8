#include "core/animation/head/head_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/algebra/elimination.h"
#include "core/base/math.h"
#include "core/geometry/rotation.h"

namespace penpose::animation {

Seen see(const Fit& fit, const HeadTurn& turn, const glm::dvec3& x) {
  const glm::dvec3 y = turn.rotation * x;
  const double growth = turn.scale / std::max(0.1, 1.0 + fit.nearness * y.z);
  return {{y.x * growth, y.y * growth}, growth};
}

PxPoint middle(std::span<const PxPoint> points) {
  PxPoint sum;
  for (const PxPoint& p : points) sum = sum + p;
  return sum * (1.0 / static_cast<double>(points.size()));
}

double extent_of(const Fit& fit) {
  double sum = 0;
  for (const glm::dvec3& x : fit.shape) sum += x.x * x.x + x.y * x.y;
  return std::sqrt(sum / static_cast<double>(fit.shape.size()));
}

namespace {

/// The shape as a head that is turned so shows it, before scale, roll and shift.
std::vector<PxPoint> shown(const Fit& fit, const glm::dmat3& rotation) {
  HeadTurn turn;
  turn.rotation = rotation;
  std::vector<PxPoint> places;
  for (const glm::dvec3& x : fit.shape) places.push_back(see(fit, turn, x).place);
  return places;
}

}  // namespace

HeadTurn similarity(const Fit& fit, const glm::dmat3& rotation, Roll roll) {
  const auto places = shown(fit, rotation);
  const PxPoint middle_shown = middle(places);
  const PxPoint middle_seen = middle(fit.seen);
  double real = 0;
  double imaginary = 0;
  double square = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PxPoint x = places[i] - middle_shown;
    const PxPoint p = fit.seen[i] - middle_seen;
    real += x.x * p.x + x.y * p.y;
    imaginary += x.x * p.y - x.y * p.x;
    square += x.x * x.x + x.y * x.y;
  }
  HeadTurn turn;
  turn.rotation = rotation;
  if (roll == Roll::kept) imaginary = 0;
  const double size = std::sqrt(real * real + imaginary * imaginary);
  if (!(size > 1e-12 * square) || (roll == Roll::kept && real < 0)) {
    turn.shift = middle_seen - fit.pivot - middle_shown;
    return turn;
  }
  turn.scale = size / square;
  const double c = real / size;
  const double s = imaginary / size;
  turn.rotation = glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * rotation;
  const PxPoint moved = {c * middle_shown.x - s * middle_shown.y, s * middle_shown.x + c * middle_shown.y};
  turn.shift = middle_seen - fit.pivot - moved * turn.scale;
  return turn;
}

double residual(const Fit& fit, const HeadTurn& turn) {
  double sum = 0;
  for (std::size_t i = 0; i < fit.shape.size(); ++i) {
    const PxPoint left = fit.seen[i] - fit.pivot - turn.shift - see(fit, turn, fit.shape[i]).place;
    sum += left.x * left.x + left.y * left.y;
  }
  return std::sqrt(sum / static_cast<double>(fit.shape.size()));
}

namespace {

/// One step of Gauss-Newton for the turn about three axes, the scale's logarithm and the shift. Turns out of the plane
/// are damped, so that stable points which lie nearly in a plane cannot throw them about.
bool refine(const Fit& fit, double extent, HeadTurn& turn) {
  algebra::Equations<6> normal{};
  for (std::size_t i = 0; i < fit.shape.size(); ++i) {
    const Seen at = see(fit, turn, fit.shape[i]);
    const glm::dvec3 y = turn.rotation * fit.shape[i] * at.growth;  // the growth's own slope is left to the next step
    const std::array<std::array<double, 6>, 2> slope{
        {{0, y.z, -y.y, y.x, 1, 0}, {-y.z, 0, y.x, y.y, 0, 1}}};  // wx wy wz log(scale) shift
    const PxPoint left = fit.seen[i] - fit.pivot - turn.shift - PxPoint{y.x, y.y};
    const std::array<double, 2> rest{left.x, left.y};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      for (std::size_t r = 0; r < 6; ++r) {
        for (std::size_t c = 0; c < 6; ++c) normal[r][c] += slope[axis][r] * slope[axis][c];
        normal[r][6] += slope[axis][r] * rest[axis];
      }
    }
  }
  const double damping = 1e-3 * extent * extent * turn.scale * turn.scale;
  normal[0][0] += damping;
  normal[1][1] += damping;
  const auto step = algebra::solve(normal, 1e-12);
  if (!step) return false;
  const auto& s = *step;
  const glm::dvec3 axis{s[0], s[1], s[2]};
  double angle = geometry::length(axis);
  if (!std::isfinite(angle + s[3] + s[4] + s[5]) || std::abs(s[3]) > 2) return false;
  const double limit = 0.5;
  const glm::dvec3 direction = angle > 0 ? axis / angle : glm::dvec3(0, 0, 1);
  angle = std::min(angle, limit);
  turn.rotation = geometry::rotation_about(direction, angle) * turn.rotation;
  turn.scale *= base::exp(s[3]);
  turn.shift = turn.shift + PxPoint{s[4], s[5]};
  return angle > 1e-7 || std::abs(s[4]) + std::abs(s[5]) > 1e-6;
}

}  // namespace

glm::dmat3 find_rotation(const Fit& fit) {
  HeadTurn turn = similarity(fit, glm::dmat3(1));
  const glm::dmat3 flat = turn.rotation;
  const double extent = extent_of(fit);
  constexpr int k_steps = 25;
  for (int i = 0; i < k_steps && refine(fit, extent, turn); ++i) {
  }
  return turn.rotation[2][2] > 0.3 ? turn.rotation : flat;
}

double angle_of(const glm::dmat3& rotation) {
  return base::acos(std::clamp((rotation[0][0] + rotation[1][1] + rotation[2][2] - 1) / 2, -1.0, 1.0));
}

glm::dmat3 part_of(const glm::dmat3& rotation, double share) {
  const auto& r = rotation;
  const glm::dvec3 axis{r[1][2] - r[2][1], r[2][0] - r[0][2], r[0][1] - r[1][0]};
  const double length = geometry::length(axis);
  return length > 1e-9 ? geometry::rotation_about(axis / length, share * angle_of(rotation)) : rotation;
}

}  // namespace penpose::animation
