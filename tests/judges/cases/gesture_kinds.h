#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::judges {

/// A kind of gesture: how lines are bent in the picture, and which muscles (parts.h) an artist means by it.
struct GestureKind {
  /// Where a point of a line goes. `s`: 0 to 1 along the line; `t`: -1 to 1 across the mouth; `half`: half of the
  /// mouth's width, px.
  using Bend = std::function<geometry::PxPoint(geometry::PxPoint p, double s, double t, double half)>;
  struct Line {
    std::string name;
    Bend bend;
    std::string towards;  ///< else: a line that it goes to, by `share` of the way
    double share = 0;
  };
  std::string name;
  std::vector<Line> lines;
  std::vector<std::vector<std::string>> needed;  ///< of each group one
  std::vector<std::string> accepted;
};

/// Which lines of the mouth are drawn.
enum class Lips : std::uint8_t { both, upper, lower };

// Sizes are px of a face of 800, or per cent of the mouth's width. Names end with the size, cut to a whole number.

/// Corners up by `px`; the mouth is `wider` than before by this factor.
[[nodiscard]] GestureKind smile(double px, double wider = 1.05, Lips lips = Lips::both);
[[nodiscard]] GestureKind frown(double px, Lips lips = Lips::both);
[[nodiscard]] GestureKind open_mouth(double px, Lips lips = Lips::both);
[[nodiscard]] GestureKind narrow_mouth(double per_cent);
[[nodiscard]] GestureKind wide_mouth(double per_cent);
[[nodiscard]] GestureKind smirk(double px, bool left);
[[nodiscard]] GestureKind mouth_aside(double px, bool left);
[[nodiscard]] GestureKind upper_lip_up(double px);
[[nodiscard]] GestureKind lower_lip_down(double px);

[[nodiscard]] GestureKind brows_up(double px);
[[nodiscard]] GestureKind one_brow_up(double px, bool left);
/// Inner ends down by `px` and together.
[[nodiscard]] GestureKind furrow(double px);
[[nodiscard]] GestureKind one_furrow(double px, bool left);
[[nodiscard]] GestureKind sad_brows(double px);

/// Lids that close by a share of the way.
[[nodiscard]] GestureKind wink(double share, bool left);
[[nodiscard]] GestureKind blink(double share);
[[nodiscard]] GestureKind eyes_wide(double px);

/// Both at once. Precondition: they draw no line in common.
[[nodiscard]] GestureKind combined(const GestureKind& a, const GestureKind& b);

}  // namespace penpose::judges
