#pragma once

#include <span>
#include <vector>

#include "core/articulation/measure/strain.h"
#include "core/articulation/motion/curve_skin.h"
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
  bool whole = false;  ///< also keep vertices that do not move, and the motion of the nodes
  bool found = false;  ///< the surface, if any, was not chosen: what gives way on it stays near to what was drawn
};

/// The range of a deformer's parameter.
struct Range {
  double minimum = 0;
  double maximum = 1;
};

/// A motion with its strain.
struct MeasuredMotion {
  CurveSkin skin;
  std::vector<std::uint32_t> vertices;
  std::vector<double> weights;
  Strain strain;       ///< the worst at several amounts
  CurveSkin of_nodes;  ///< where `whole`: the inner nodes of the patch, as seen
};

/// Tries translation and rotation, or the one in `mode`, and takes the one that distorts the surface least. Its weights
/// may reach into the region of specific interest to several depths: the shallowest that turns no triangle over is
/// used. Errors: a vertex whose joints flatten it.
[[nodiscard]] base::Result<MeasuredMotion> measured_motion(const MeasuredParts& parts, Mode mode, Range range);

/// The worst strain at several amounts of a skin of the patch's inner nodes.
[[nodiscard]] Strain strain_at(const MeasuredParts& parts, const CurveSkin& of_nodes, std::span<const double> amounts);

}  // namespace penpose::articulation
