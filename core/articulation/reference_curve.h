#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/articulation/canvas.h"
#include "core/articulation/region.h"
#include "core/base/result.h"
#include "core/geometry/camera.h"

namespace penpose::articulation {

/// The kernel of "light smoothing" (method, section 3, step 3).
inline constexpr std::size_t k_light_kernel = 5;

/// The reference curve inferred from V_s: its vertices ordered by projected x (by projected y where that extent is
/// larger), their world positions smoothed by a triangle filter whose kernel is a third of their number, then lightly,
/// and spaced evenly as `count` points. Errors: vertices that make no curve.
[[nodiscard]] base::Result<std::vector<ModelPoint>> infer_reference(const Canvas& canvas, const Region& region,
                                                                    std::span<const std::uint32_t> specific,
                                                                    std::size_t count);

/// The reference curve drawn by hand: the stroke projected onto the visible surface, lightly smoothed with its ends
/// fixed, and spaced evenly as `count` points in world space. Errors: the line does not touch the mesh.
[[nodiscard]] base::Result<std::vector<ModelPoint>> drawn_reference(const Canvas& canvas,
                                                                    const geometry::Camera& camera,
                                                                    std::span<const PxPoint> stroke, std::size_t count);

}  // namespace penpose::articulation
