#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/articulation/surface/surface.h"
#include "core/base/result.h"
#include "core/base/state_hash.h"
#include "core/geometry/camera.h"

namespace penpose::articulation {

using geometry::ModelPoint;
using geometry::ModelVector;
using geometry::PxPoint;

/// How a deformer moves from its reference curve to its target (method, section 3).
enum class Mode : std::uint8_t { automatic, translate, rotate };

/// How far into the model a lasso reaches: also to hidden parts, or only to visible ones.
enum class Reach : std::uint8_t { through, front };

/// The widest range that a deformer's parameter may have.
inline constexpr double k_widest_amount = 10;
/// The most points that a curve may have.
inline constexpr std::size_t k_most_points = 100000;
/// The most other targets that a deformer may have.
inline constexpr std::size_t k_most_betweens = 64;

/// Another target of a deformer: where its curve is at a value other than 0 and 1.
struct Between {
  double value = 0.5;
  std::vector<PxPoint> target;
  std::optional<geometry::CameraPose> camera;  ///< set when it was drawn under another camera than the regions
  friend bool operator==(const Between&, const Between&) = default;
};

/// The strokes that make one deformer: everything needed to build it again, and that a user can redraw. Curves are in
/// px of the viewport. Strokes are drawn on the model at rest.
struct Sketch {
  std::string name;
  geometry::Viewport viewport;
  geometry::CameraPose camera;     ///< of the two regions, and of the reference curve unless it has its own
  std::vector<PxPoint> general;    ///< lasso of the region of general interest
  std::vector<PxPoint> specific;   ///< lasso of the region of specific interest
  std::vector<PxPoint> reference;  ///< empty: inferred from the region of specific interest
  std::vector<PxPoint> target;
  std::optional<geometry::CameraPose> reference_camera;  ///< set when the camera moved before the reference was drawn
  std::optional<geometry::CameraPose> target_camera;     ///< set when the camera moved before the target was drawn
  Mode mode = Mode::automatic;
  Surface surface;
  double minimum = 0;        ///< range of the parameter, <= 0
  double maximum = 1;        ///< > 0
  bool paper = false;        ///< built as in the paper (method, section 3), without measuring strain
  bool other_sheet = false;  ///< a drawn reference is on the other of two sheets; not where `paper`
  Reach reach = Reach::through;
  std::uint32_t piece = 0;        ///< which of the pieces inside the first lasso; 0 is the nearest
  std::vector<Between> betweens;  ///< ascending by their values; none where `paper`
  friend bool operator==(const Sketch&, const Sketch&) = default;
};

/// Checks that need no model. Errors carry the key of the sketch file as their place ("target",
/// "target/3", "surface/sphere/radius"): no name, a missing curve, too many points, coordinates that are not finite or
/// beyond a million px, a ball without radius, a range without 0, other targets that are not in ascending order within
/// the range, or have the value 0 or 1.
[[nodiscard]] base::Status check_sketch(const Sketch& sketch);

/// Adds all strokes and settings to a canonical hash.
void add_to_hash(base::StateHash& hash, const Sketch& sketch);

}  // namespace penpose::articulation
