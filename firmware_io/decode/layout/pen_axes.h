#pragma once

#include "firmware_io/decode/layout/pen_layout.h"

namespace penpose::decode {

/// Takes over the range and unit of a control's field, unless the axes have one already or the control is no axis.
void note_axis(PenAxes& axes, PenRole role, const hid::Field& field);

/// Finds the device's axes among those of its reports, and how the reports' own ranges lead to them. Distances stay in
/// their own range.
void unite_axes(PenLayout& layout);

}  // namespace penpose::decode
