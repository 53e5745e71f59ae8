#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/articulation/region/canvas.h"
#include "core/articulation/surface/held_surface.h"
#include "core/geometry/camera.h"

namespace penpose::articulation {

/// The two curves of a deformer, with equally many points, and the camera of the target.
struct CurvesOverBall {
  std::span<const ModelPoint> reference;
  std::span<const ModelPoint> target;
  const geometry::Camera& camera;
};

/// A ball to go around, and the piece of the model that it is.
struct BallUnder {
  std::shared_ptr<const HeldSurface> held;
  std::uint32_t piece = 0;  ///< mesh::TriangleMesh::components
};

/// The ball that a curve lies on, as the margin of a lid lies on the eye: another piece of the model than that of
/// `vertex`, most of whose vertices lie on a sphere (a half of one is enough). Points that move over it keep their
/// distance from its centre, and go around where it bulges, as a cornea does. Nothing where the curve does not lie on a
/// ball, or the target leaves it as seen from the camera.
[[nodiscard]] std::optional<BallUnder> ball_under(const Canvas& canvas, std::uint32_t vertex,
                                                  const CurvesOverBall& curves);

}  // namespace penpose::articulation
