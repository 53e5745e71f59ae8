#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "core/animation/head/head_motion.h"

namespace penpose::animation {

/// Points of the neutral face relative to the pivot, and their positions in another frame.
struct Fit {
  std::vector<glm::dvec3> shape;  ///< x right, y down, z away, px of the neutral frame
  std::vector<PxPoint> seen;      ///< px of the other frame, one each
  PxPoint pivot;
  double nearness = 0;  ///< relative growth of a point for each px nearer to the camera; 0: orthographic
};

/// The projection of a point of the neutral shape, relative to pivot and shift, and its perspective scale.
struct Seen {
  PxPoint place;
  double growth = 1;
};
[[nodiscard]] Seen see(const Fit& fit, const HeadTurn& turn, const glm::dvec3& x);

/// Mean of the points. Precondition: at least one.
[[nodiscard]] PxPoint middle(std::span<const PxPoint> points);

/// Root mean square distance of the shape's points from the pivot, px; at least one point.
[[nodiscard]] double extent_of(const Fit& fit);

enum class Roll : std::uint8_t { found, kept };

/// The least-squares similarity after a given turn, in closed form: with points as complex numbers relative to their
/// means, the factor is sum(conj(x) p) / sum(|x|^2). `kept`: without its roll.
[[nodiscard]] HeadTurn similarity(const Fit& fit, const glm::dmat3& rotation, Roll roll = Roll::found);

/// The head's turn: Gauss-Newton, starting from the similarity. A tracker cannot see a head that faces away; in that
/// case the similarity is kept.
[[nodiscard]] glm::dmat3 find_rotation(const Fit& fit);

/// Root mean square distance left between the shape at this turn and the seen points, px.
[[nodiscard]] double residual(const Fit& fit, const HeadTurn& turn);

/// Angle of a rotation, radians, 0..pi.
[[nodiscard]] double angle_of(const glm::dmat3& rotation);

/// The rotation scaled to a share of its angle, 0..1.
[[nodiscard]] glm::dmat3 part_of(const glm::dmat3& rotation, double share);

}  // namespace penpose::animation
