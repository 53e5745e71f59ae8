#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/articulation/region/region.h"
#include "core/base/result.h"
#include "core/curve/sheet_line.h"
#include "core/geometry/camera.h"

namespace penpose::articulation {

/// The kernel of "light smoothing" (method, section 3, step 3).
inline constexpr std::size_t k_light_kernel = 5;

/// The reference curve inferred from V_s: its vertices ordered by projected x (by projected y where that extent is
/// larger), their world positions smoothed by a triangle filter whose kernel is a third of their number, then lightly,
/// and spaced evenly as `count` points. Errors: vertices that form no curve.
[[nodiscard]] base::Result<std::vector<ModelPoint>> infer_reference(const Canvas& canvas, const Region& region,
                                                                    std::span<const std::uint32_t> specific,
                                                                    std::size_t count);

/// Turns an inferred reference round that is attached at its last point alone, where that end tells the target's
/// direction otherwise than the first one: a trunk stays on its head, whichever way its target runs.
void begin_where_attached(const Canvas& canvas, const Region& region, std::span<const std::uint32_t> specific,
                          const geometry::Camera& camera, std::span<const PxPoint> target,
                          std::vector<ModelPoint>& reference);

/// Why an inferred reference cannot be trusted, in words for a user; empty where it can. Its vertices are on two sheets
/// of the surface (both lips), or it runs far from the vertices it was inferred from.
[[nodiscard]] std::string doubt_of_inferred(const Canvas& canvas, const Region& region,
                                            std::span<const std::uint32_t> specific,
                                            std::span<const ModelPoint> inferred);

/// The reference curve drawn by hand: the stroke projected onto the visible surface, lightly smoothed with its ends
/// fixed, and spaced evenly as `count` points in world space. Errors: the line does not touch the mesh.
[[nodiscard]] base::Result<std::vector<ModelPoint>> drawn_reference(const Canvas& canvas,
                                                                    const geometry::Camera& camera,
                                                                    std::span<const PxPoint> stroke, std::size_t count);

/// A drawn reference that stays on one sheet of the surface.
struct SheetReference {
  std::vector<ModelPoint> points;
  std::vector<ModelVector> aside;  ///< from each point to the pen
  double kept = 1;                 ///< share of the line that was not cut off
};

/// Whether a triangle of the model may be meant.
using MeantTriangles = std::function<bool(const mesh::Triangle&)>;

/// The same on one sheet of the surface (core/curve/sheet_line.h), or on the other one of two. Where
/// some triangles are meant, it is on those, whatever else the line crosses. Errors: as drawn_reference; no other
/// sheet.
[[nodiscard]] base::Result<SheetReference> sheet_reference(const Canvas& canvas, const geometry::Camera& camera,
                                                           std::span<const PxPoint> stroke, std::size_t count,
                                                           curve::SheetChoice choice, const MeantTriangles& meant = {});

}  // namespace penpose::articulation
