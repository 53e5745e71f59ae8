#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "core/animation/head/head_motion.h"

namespace penpose::animation {

/// Points of the neutral face about the pivot, and where they are in another frame.
struct Fit {
  std::vector<glm::dvec3> shape;  ///< x right, y down, z away, px of the neutral frame
  std::vector<PxPoint> seen;      ///< px of the other frame, one each
  PxPoint pivot;
  double nearness = 0;  ///< how much a point grows with each px that it is nearer to the camera; 0: seen from afar
};

/// Where a point of the neutral shape is seen, about the pivot and the shift, and how much it grows there.
struct Seen {
  PxPoint place;
  double growth = 1;
};
[[nodiscard]] Seen see(const Fit& fit, const HeadTurn& turn, const glm::dvec3& x);

/// Mean of the points; at least one.
[[nodiscard]] PxPoint middle(std::span<const PxPoint> points);

/// Root mean square distance of the shape's points from the pivot, px; at least one point.
[[nodiscard]] double extent_of(const Fit& fit);

enum class Roll : std::uint8_t { found, kept };

/// The similarity of least squares in closed form, after a turn that is given: with points as complex numbers about
/// their middles, the factor is sum(conj(x) p) / sum(|x|^2). `kept`: without its roll.
[[nodiscard]] HeadTurn similarity(const Fit& fit, const glm::dmat3& rotation, Roll roll = Roll::found);

/// How the head is turned: Gauss-Newton from the similarity. A head that would face away is none that a tracker sees,
/// then the similarity stands.
[[nodiscard]] glm::dmat3 find_rotation(const Fit& fit);

/// Root mean square distance left between the shape on a head that stands so and what is seen, px.
[[nodiscard]] double residual(const Fit& fit, const HeadTurn& turn);

/// Angle of a rotation, radians, 0..pi.
[[nodiscard]] double angle_of(const glm::dmat3& rotation);

/// The same turn by a share of its angle, 0..1.
[[nodiscard]] glm::dmat3 part_of(const glm::dmat3& rotation, double share);

}  // namespace penpose::animation
