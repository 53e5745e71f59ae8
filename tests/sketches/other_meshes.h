#pragma once

#include <memory>

#include "core/articulation/region/canvas.h"

namespace penpose::sketches {

using articulation::Canvas;
using geometry::ModelPoint;

/// A smooth warp of a head: longer below, wider above, bent to one side and lopsided, so that nothing about it is as it
/// was measured. Sizes are shares of the head's.
class Warp {
 public:
  explicit Warp(const Canvas& canvas);
  [[nodiscard]] ModelPoint operator()(const ModelPoint& p) const;

 private:
  ModelPoint middle_{0};
  double size_ = 1;
};

[[nodiscard]] std::shared_ptr<const Canvas> warped(const Canvas& canvas, const Warp& warp);
/// The same surface with fewer triangles and those of every shape: edges are taken out, the shortest first, until this
/// share of the vertices is left.
[[nodiscard]] std::shared_ptr<const Canvas> coarser(const Canvas& canvas, double share);

}  // namespace penpose::sketches
