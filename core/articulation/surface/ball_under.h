#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

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

/// A piece of the model that is a ball.
struct Ball {
  ModelPoint center{0};
  double radius = 0;
  std::uint32_t piece = 0;  ///< mesh::TriangleMesh::components

  /// Whether a point is inside of it, deeper than a lid ever lies.
  [[nodiscard]] bool hides(const ModelPoint& point) const;
};

/// The pieces of the model about a curve, but for `own`, most of whose vertices lie on a sphere; a half of one is
/// enough. The largest is first: of balls within each other a curve lies on the outermost.
[[nodiscard]] std::vector<Ball> balls_about(const Canvas& canvas, std::uint32_t own, std::span<const ModelPoint> curve);

/// A ball as the surface that a curve lies on, as the margin of a lid lies on the eye. Points that move over it keep
/// their height above it, also where it bulges, as a cornea does. Null where the curve does not lie on it, or the
/// target leaves it as seen from the camera.
[[nodiscard]] std::shared_ptr<const HeldSurface> ball_under(const Canvas& canvas, const Ball& ball,
                                                            const CurvesOverBall& curves);

}  // namespace penpose::articulation
