#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/animation/head/head_motion.h"
#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "core/posing/problem.h"

namespace penpose::animation {

/// A tracked curve and the curve of the model that it drives.
struct TrackedCurve {
  std::vector<std::size_t> points;            ///< numbers of the track's points along the curve, at least two
  std::vector<posing::CurvePoint> reference;  ///< the model's curve, at least two points, in either direction
  std::vector<std::size_t> anchor;            ///< points of the track that the curve follows where the head is in doubt
  double weight = 1;                          ///< of its points in the energy
  std::optional<std::size_t> meets;           ///< the curve that it closes on, as one lid on the other
  std::optional<std::size_t> touches;         ///< the curve that it lies on at rest, as one lip on the other
  double gain = 1;                            ///< its movement is this many times the tracked one
};

/// The index of each curve's first point among the concatenated points of all curves.
[[nodiscard]] std::vector<std::size_t> first_points(std::span<const TrackedCurve> curves);

/// How a point takes over movement of the curve that its own curve meets (share_contact).
struct ContactShare {
  std::array<std::size_t, 2> across{};  ///< the two points on the other curve that it meets between
  double between = 0;                   ///< 0..1: where between them
  double takes_over = 0;  ///< the share of their movement that it makes instead, in the opposite direction
};

/// Tracked curves transferred to the model's image plane.
struct Transfer {
  std::vector<posing::CurvePoint> points;         ///< of all curves, in their order: one for each tracked point
  std::vector<geometry::PxPoint> places;          ///< d_i: where they are at rest, px of the camera
  std::vector<std::size_t> tracked;               ///< the track's point that drives each
  std::vector<std::size_t> curve;                 ///< the curve of each
  std::vector<std::vector<std::size_t>> anchors;  ///< one list a curve
  std::vector<double> weights;
  std::vector<double> scale;                         ///< |C_u| / |C_v0| times the gain, one a point
  std::vector<ContactShare> contact_shares;          ///< one a point, or none
  std::vector<std::array<std::size_t, 2>> contacts;  ///< points of curves that touch at rest, across from each other
  double turn_cosine = 1;                            ///< the neutral frame's own roll, removed from every movement
  double turn_sine = 0;
};

/// Matches tracked curves with curves of the model as they are in `rest` (method, section 4). Point i of the model's
/// curve is at the share of its length at which the tracked point is in the neutral frame. A curve that runs the other
/// way is reversed, and a closed one is also shifted, by the best fit after both are brought to one place and size. The
/// movement of a curve that meets another is scaled by how much wider the gap between the two is on the model, relative
/// to their lengths, so that narrow eyes close wide ones. Errors (place "/curves/N"):
/// a point that does not exist, fewer than two points, a curve without length.
[[nodiscard]] base::Result<Transfer> make_transfer(const rig::Rig& rig, std::span<const double> rest,
                                                   const PointTrack& track, const StillTrack& still,
                                                   std::span<const TrackedCurve> curves,
                                                   const geometry::Camera& camera);

/// d_i'(f) = d_i + c_i(f) |C_u| / |C_v0|: the target of each point, px of the camera. c_i is the point's offset less
/// the mean offset of its curve's anchor times the frame's doubt: an error of the head's fit near the curve, as when a
/// face longer than the average nods, moves both alike. Precondition: the offsets of a frame that was seen; one place a
/// point.
void target_places(const Transfer& transfer, std::span<const PxPoint> offsets, double doubt,
                   std::span<geometry::PxPoint> targets);

}  // namespace penpose::animation
