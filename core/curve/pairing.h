#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/curve/stroke.h"
#include "core/geometry/camera.h"

namespace penpose::curve {

/// Ends within this distance are "the same place" on a viewport 1000 px high; it scales with the height, so that a
/// dense screen behaves like any other (method, sections 1 and 3).
inline constexpr double k_pairing_distance_px = 10;
[[nodiscard]] double pairing_distance_px(geometry::Viewport viewport);

/// Whether both ends are in the same place, as in a line around a lip or an eye.
[[nodiscard]] bool is_closed(std::span<const PxPoint> line, double distance_px);

/// True when the target runs against the reference: its end is nearer to the reference's start than its own start is
/// (method, section 1). Compared in px on the image plane. Precondition: neither is empty.
[[nodiscard]] bool runs_backwards(std::span<const PxPoint> reference, std::span<const PxPoint> target);

/// The 3D point on the ray through a px position that is as far from the eye as `reference` is now.
[[nodiscard]] ModelPoint lift(PxPoint position, const ModelPoint& reference, const geometry::Camera& camera);

/// A drawn target matched with a reference curve.
struct PairedTarget {
  std::vector<ModelPoint> points;  ///< one for each reference point
  std::vector<double> shares;      ///< share of the drawn line's length at which each point lies, for weights along it
  bool reversed = false;           ///< the line was drawn against the reference
  std::size_t shift = 0;           ///< closed curves: reference point i goes with place i + shift of the drawn loop
};

/// Orders, reparameterises and lifts a drawn target (method, section 1). `reference` are the positions of the
/// reference's points now, on the posed mesh. Point i of the target sits at the share of its length that reference
/// point i has of the reference's on the image plane, which for an evenly spaced reference is (i - 1)/(n - 1). Two
/// closed curves have no reliable start: of all cyclic shifts and both directions, the pairing with the least sum of
/// distances is kept. Errors: a line of fewer than two points or of no length; a reference behind the camera or
/// without length on the image plane.
[[nodiscard]] base::Result<PairedTarget> pair_target(std::span<const ModelPoint> reference,
                                                     std::span<const PxPoint> target, const geometry::Camera& camera);

}  // namespace penpose::curve
