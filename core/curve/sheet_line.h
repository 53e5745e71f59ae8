#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/curve/projection.h"
#include "core/curve/sheets.h"

namespace penpose::curve {

/// How far from the pen a line may stick to a sheet, px of a view 1000 px high: rims of eyes and mouths are met from
/// both sides by hands that mean one.
inline constexpr double k_stick_px = 8.0;

/// Before a part of a line is cut off, the whole line may stick farther from the pen, up to this many times as far.
/// Seen from near, a lip is wide and its bow high, and a hand draws it flatter by more px than rims are wide.
inline constexpr int k_farthest_stick = 4;

/// A surface that lines are drawn on.
struct SheetSurface {
  const geometry::TriangleBvh& tree;
  std::span<const glm::vec3> positions;  ///< of all vertices, those of the tree
  std::span<const mesh::Triangle> triangles;
  Sheets& sheets;
};

/// Of two sheets that a line may belong to: the one that is nearer to most of it, or the next one.
enum class SheetChoice : std::uint8_t { nearer, other };

/// A reference curve that stays on one sheet of the surface: `count` points, evenly along the line. Where every sample
/// of the line hits one sheet, the same as surface_curve. Else each sample may take what lies behind the first hit and
/// what lies within k_stick_px beside the pen where it stays beside its neighbours; the sequence with the least cost is
/// found by dynamic programming (Viterbi 1967): px beside the pen, what is hidden or seen from behind, and above all
/// going over from one sheet to another. Parts of a model that touch may be crossed at a cost. Where a line leaves its
/// sheet all the same, it may stick up to k_farthest_stick times as far from the pen; what leaves it even then is cut
/// off, and the longest run in px is kept. Every point of the result is a neighbour of the next. `dropped` counts
/// samples of the line outside of that run. Errors as project_stroke; no other sheet near the line where that is asked
/// for; a line of leaps alone.
[[nodiscard]] base::Result<ProjectedStroke> sheet_curve(std::span<const PxPoint> stroke, std::size_t count,
                                                        const geometry::Camera& camera, const SheetSurface& surface,
                                                        SheetChoice choice = SheetChoice::nearer);

}  // namespace penpose::curve
