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

/// How strictly a line holds on to its sheet. From `close` on a place beside the pen comes nearer to it only where it
/// stays beside its neighbours, so that the line does not change its sheet where two are close. `firm`: so does every
/// point of the result, also where all samples lie on one sheet and a point between two of them does not, and where the
/// steps to a part that touches add up to a leap; what cannot be held is cut. `far`: before a part is cut off, the
/// whole line may stick farther from the pen, up to k_farthest_stick times as far. Seen from near, a lip is wide and
/// its bow high, and a hand draws it flatter by more px than rims are wide.
enum class Holding : std::uint8_t { loose, close, firm, far };
inline constexpr int k_farthest_stick = 4;

/// Of lines that pose, by the rules of drawing: `close` from k_close_rules on, `firm` from k_firm_rules on, `far` from
/// k_far_rules on.
inline constexpr std::uint32_t k_close_rules = 6;
inline constexpr std::uint32_t k_firm_rules = 7;
inline constexpr std::uint32_t k_far_rules = 8;
[[nodiscard]] constexpr Holding holding_by(std::uint32_t rules) {
  return rules >= k_far_rules     ? Holding::far
         : rules >= k_firm_rules  ? Holding::firm
         : rules >= k_close_rules ? Holding::close
                                  : Holding::loose;
}

/// A surface that lines are drawn on.
struct SheetSurface {
  const geometry::TriangleBvh& tree;
  std::span<const glm::vec3> positions;  ///< of all vertices, those of the tree
  std::span<const mesh::Triangle> triangles;
  Sheets& sheets;
  Holding holding = Holding::loose;
};

/// Of two sheets that a line may belong to: the one that is nearer to most of it, or the next one.
enum class SheetChoice : std::uint8_t { nearer, other };

/// A reference curve that stays on one sheet of the surface: `count` points, evenly along the line. Where every sample
/// of the line hits one sheet, the same as surface_curve. Else each sample may take what lies behind the first hit and
/// what lies within k_stick_px beside the pen; the sequence with the least cost is found by dynamic programming
/// (Viterbi 1967): px beside the pen, what is hidden or seen from behind, and above all going over from one sheet to
/// another. Parts of a model that touch may be crossed at a cost; where a line leaves its sheet all the same it is cut,
/// and the longest run in px is kept; by Holding::far only where it would be cut k_farthest_stick times as far, too.
/// `dropped` counts samples of the line outside of that run. Errors as
/// project_stroke; no other sheet near the line where that is asked for; by Holding::firm a line of leaps alone.
[[nodiscard]] base::Result<ProjectedStroke> sheet_curve(std::span<const PxPoint> stroke, std::size_t count,
                                                        const geometry::Camera& camera, const SheetSurface& surface,
                                                        SheetChoice choice = SheetChoice::nearer);

}  // namespace penpose::curve
