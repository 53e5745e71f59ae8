#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/articulation/sketch.h"

namespace penpose::sketches {

using articulation::Canvas;
using articulation::Sketch;
using geometry::ModelPoint;
using geometry::PxPoint;

/// One control as a user would sketch it, and how strong its target is.
struct SketchCase {
  std::string mesh;
  std::string feature;   ///< "jaw"
  std::string strength;  ///< weak, usual or strong
  std::shared_ptr<const Canvas> canvas;
  Sketch sketch;
};

/// Sketches on the built-in head, the heads and the elephant of the shared data (left out where it is missing), and on
/// a beast of this program's own making. Every feature at three strengths.
[[nodiscard]] std::vector<SketchCase> sketch_cases();
/// The same features on four meshes more, which no constant of the program was chosen on: another beast, a face with a
/// third of its vertices, a head that was warped out of shape, and that one with a sixth of its vertices.
[[nodiscard]] std::vector<SketchCase> other_sketch_cases();
/// All of these with lassos, features and targets changed at random, as other hands would draw them; some cores then
/// lie beside the model.
[[nodiscard]] std::vector<SketchCase> varied_sketch_cases(std::uint64_t seed);

}  // namespace penpose::sketches
