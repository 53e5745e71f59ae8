#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/articulation/region/kept_surface.h"
#include "core/articulation/sketch.h"
#include "core/base/result.h"
#include "core/geometry/camera.h"

namespace penpose::articulation {

using geometry::PxPoint;

/// The region of general interest (method, section 3, step 1): V_g with what the next steps need of each vertex.
struct Region {
  std::vector<std::uint32_t> vertices;  ///< ascending
  std::vector<PxPoint> seen;            ///< one a vertex: where the camera sees it
  std::vector<double> border_px;        ///< one a vertex: g_i, distance to the lasso
  std::uint32_t pieces = 1;             ///< inside the lasso that could be meant
};

/// Which part of a model a lasso selects.
struct Taken {
  Reach reach = Reach::through;
  std::uint32_t piece = 0;  ///< 0 is the one with the vertex closest to the camera, 1 the next
  friend bool operator==(const Taken&, const Taken&) = default;
};

/// Whether to compute the distances to the lasso.
enum class Borders : std::uint8_t { measured, skipped };

/// Takes all vertices inside the lasso (hidden ones too), splits them into connected components, and selects the one
/// with the vertex closest to the camera among those of more than 10 vertices. Vertices of a seam count as connected.
/// Vertices of the surface that the deformer slides over are never selected, even if an eyeball is nearer to the camera
/// than its lid. With `Reach::front` only visible vertices count: those that face the camera with nothing in front.
/// Errors: those of the lasso; nothing inside; only small pieces inside; a piece that does not exist.
[[nodiscard]] base::Result<Region> general_region(const Canvas& canvas, const geometry::Camera& camera,
                                                  std::span<const PxPoint> lasso, const KeptSurface& surface = {},
                                                  Borders borders = Borders::measured, const Taken& taken = {});

/// A region of specific interest within a general one (step 2).
struct Weights {
  std::vector<double> weights;          ///< one a vertex of the region: 1 inside, else g/(g + c), 0 at the border
  std::vector<std::uint32_t> specific;  ///< places in Region::vertices of V_s, ascending
};

/// An error where a lasso really crosses itself (an eight, or twice around): where its area counted by winding number
/// differs from the area inside. Ends that overlap are no crossing.
[[nodiscard]] base::Status check_crossing(std::span<const PxPoint> lasso);

/// The error of a second lasso with nothing of the region inside: it says on which side of the region the lasso is.
[[nodiscard]] base::Error core_outside(const Region& region, std::span<const PxPoint> lasso);

/// Errors: those of the lasso; no vertex of the region inside.
[[nodiscard]] base::Result<Weights> specific_region(const Region& region, std::span<const PxPoint> lasso);

}  // namespace penpose::articulation
