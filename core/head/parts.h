#pragma once

#include "core/head/skin.h"

namespace penpose::head {

/// A part of the sphere around the +x eye's centre, in centimetres: `radius` times the eye's, from the gaze axis
/// outwards to `degrees` (180: all of it).
[[nodiscard]] Surface make_eye_cap(double radius, double from_degrees, double to_degrees, int rings, int segments);

/// The upper row of teeth, as one rounded band behind the lips, in centimetres.
[[nodiscard]] Surface make_teeth();
/// The lower row, and a tongue, neither of which is yet joined to anything.
[[nodiscard]] Surface make_teeth_lower();
[[nodiscard]] Surface make_tongue();
/// Joins what stands in the mouth to its wall by a stem, so that the two are one surface: a triangle is taken out of
/// each where they are nearest, and a tube drawn between the holes.
void hang_on(Surface& wall, Surface& thing);

/// A cap of hair, swept to one side: it follows `skin`, sinks into it along the hair line, and is not symmetric.
[[nodiscard]] Surface make_hair(const Surface& skin);

}  // namespace penpose::head
