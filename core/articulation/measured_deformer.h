#pragma once

#include <span>
#include <vector>

#include "core/articulation/measure/strain.h"
#include "core/articulation/motion/carriage.h"
#include "core/articulation/region/canvas.h"
#include "core/articulation/region/falloff.h"

namespace penpose::articulation {

/// The curves of a deformer and what they move.
struct MeasuredParts {
  const Canvas& canvas;
  const Region& region;
  const Patch& patch;
  const Falloff& falloff;
  std::vector<ModelPoint> reference;
  std::vector<ModelPoint> target;
  KeptSurface surface;
  bool whole = false;  ///< vertices that do not move are kept, and the motion of the nodes
};

/// The range of a deformer's parameter.
struct Range {
  double minimum = 0;
  double maximum = 1;
};

/// A way of moving that was measured.
struct MeasuredMotion {
  Carriage carriage;
  std::vector<std::uint32_t> vertices;
  std::vector<double> weights;
  Strain strain;      ///< the worst at several amounts
  Carriage of_nodes;  ///< where the whole is wanted: the inner nodes of the patch, as they are seen
};

/// Of both ways of moving (or the one that is asked for) the one that distorts the surface least, and of several depths
/// to which its weights may reach into the region of specific interest the shallowest that turns no triangle over.
/// Errors: a vertex whose joints flatten it.
[[nodiscard]] base::Result<MeasuredMotion> measured_motion(const MeasuredParts& parts, Mode mode, Range range);

/// The worst at several amounts of what a carriage of the patch's inner nodes does.
[[nodiscard]] Strain strain_at(const MeasuredParts& parts, const Carriage& of_nodes, std::span<const double> amounts);

}  // namespace penpose::articulation
