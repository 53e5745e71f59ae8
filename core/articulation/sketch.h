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

/// How a deformer goes from its reference curve to its target (method, section 3).
enum class Mode : std::uint8_t { automatic, translate, rotate };

/// How far into the model a lasso reaches: to what lies behind, or only to what the camera sees.
enum class Reach : std::uint8_t { through, front };

/// The widest range that a deformer's parameter may have.
inline constexpr double k_widest_amount = 10;
/// The most points that a curve may have.
inline constexpr std::size_t k_most_points = 100000;
/// The most targets that a deformer may have beside its own.
inline constexpr std::size_t k_most_betweens = 64;

/// Another target of a deformer: where its curve is at a value other than 0 and 1.
struct InBetween {
  double value = 0.5;
  std::vector<PxPoint> target;
  std::optional<geometry::CameraPose> camera;  ///< set when it was drawn under another camera than the regions
  friend bool operator==(const InBetween&, const InBetween&) = default;
};

/// What was drawn to make one deformer: all that is needed to build it again, and what a user can draw anew. Curves are
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
  bool paper = false;        ///< built as the paper says (method, section 3), without a measure of what it distorts
  bool other_sheet = false;  ///< a drawn reference lies on the other of two sheets; not where `paper`
  Reach reach = Reach::through;
  std::uint32_t piece = 0;          ///< of the pieces inside the first lasso which one, the nearest being 0
  std::vector<InBetween> betweens;  ///< ascending by their values; none where `paper`
  friend bool operator==(const Sketch&, const Sketch&) = default;
};

/// Checks what can be checked without a model. Errors carry the key of the sketch file as their place ("target",
/// "target/3", "surface/sphere/radius"): no name, a missing curve, too many points, coordinates that are not finite or
/// beyond a million px, a ball without radius, a range without 0, other targets that are not in ascending order within
/// the range or stand where the deformer's own do.
[[nodiscard]] base::Status check_sketch(const Sketch& sketch);

/// Adds everything that was drawn to a canonical hash.
void add_to_hash(base::StateHash& hash, const Sketch& sketch);

}  // namespace penpose::articulation
