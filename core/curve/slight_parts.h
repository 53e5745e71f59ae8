#pragma once

#include "core/curve/sheet_line.h"

namespace penpose::curve {

/// A part with less than this share of the largest part's area is slight.
inline constexpr double k_slight = 0.005;
/// The most distance between a slight part's line and the surface it is attached to, as a share of the line's length.
inline constexpr double k_stand = 0.3;

/// A line drawn on slight parts is meant for the part they are attached to: lashes on a lid. Moves each such point to
/// the nearest place of the largest part that is within k_stand of all of them, and adds the offset back to `aside`.
/// Nothing changes where there is no such part.
void stand_on_body(ProjectedStroke& drawn, const SheetSurface& surface);

}  // namespace penpose::curve
