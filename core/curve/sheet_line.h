#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/curve/projection.h"
#include "core/curve/sheets.h"

namespace penpose::curve {

/// How far from the pen a line may snap to a sheet, px of a view 1000 px high: a line meant for one rim of an eye or
/// mouth often touches both.
inline constexpr double k_stick_px = 8.0;

/// Before a part of a line is cut off, the whole line may snap farther from the pen, up to this many times as far. In a
/// close view a lip is wide and its bow high, and artists draw it flatter by more px than rims are wide.
inline constexpr int k_farthest_stick = 4;

/// A surface to draw on.
struct SheetSurface {
  const geometry::TriangleBvh& tree;
  std::span<const glm::vec3> positions;  ///< of all vertices, those of the tree
  std::span<const mesh::Triangle> triangles;
  Sheets& sheets;
};

/// Of two sheets that a line may be on: the one that is nearer to most of it, or the other.
enum class SheetChoice : std::uint8_t { nearer, other };

/// A reference curve that stays on one sheet of the surface: `count` points, evenly along the line. Where every sample
/// of the line hits one sheet, the same as surface_curve. Otherwise each sample may also take a surface behind the
/// first hit, or one within k_stick_px of the pen that is next to its neighbours. Dynamic programming (Viterbi 1967)
/// finds the cheapest sequence; costs are the px from the pen, surfaces that are hidden or seen from behind, and above
/// all a change of sheet. Parts of a model that touch may be crossed at a cost. Where a line still leaves its sheet, it
/// may snap up to k_farthest_stick times as far from the pen; what leaves it even then is cut off, and the longest run
/// in px is kept. Every point of the result is a neighbour of the next. `dropped` counts samples of the line outside of
/// that run. Errors as project_stroke; no other sheet near the line if the other one was requested; a line that only
/// leaps.
[[nodiscard]] base::Result<ProjectedStroke> sheet_curve(std::span<const PxPoint> stroke, std::size_t count,
                                                        const geometry::Camera& camera, const SheetSurface& surface,
                                                        SheetChoice choice = SheetChoice::nearer);

}  // namespace penpose::curve
