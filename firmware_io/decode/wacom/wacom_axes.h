#pragma once

#include "firmware_io/decode/sample/pen_sample.h"
#include "firmware_io/decode/wacom/wacom_models.h"

namespace penpose::decode {

/// The axes of position, pressure and distance of a model; for displays with margins, those of the picture's area.
[[nodiscard]] PenAxes wacom_axes(const WacomModel& model);

/// Adds the tilt of Wacom's electromagnetic pens: -64 to 63, one unit a degree.
void add_wacom_tilt(PenAxes& axes);

/// Adds the barrel rotation of art pens (-900 to 899 for a turn) and the wheel of airbrushes.
void add_wacom_rotation_and_wheel(PenAxes& axes, bool rotation);

}  // namespace penpose::decode
