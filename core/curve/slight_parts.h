#pragma once

#include "core/curve/sheet_line.h"

namespace penpose::curve {

/// A part of less than this share of the largest one's area is slight.
inline constexpr double k_slight = 0.005;
/// How far what it stands on may be from where it was drawn, beside the length of what was drawn.
inline constexpr double k_stand = 0.3;

/// What was drawn on slight parts is meant for what they stand on: lashes on a lid. Each such point is taken to the
/// nearest place of the largest part that all of them have within k_stand; `aside` grows by the way back. Nothing
/// changes where there is no such part.
void stand_on_body(ProjectedStroke& drawn, const SheetSurface& surface);

}  // namespace penpose::curve
