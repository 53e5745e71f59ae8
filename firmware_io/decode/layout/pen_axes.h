#pragma once

#include "firmware_io/decode/layout/pen_layout.h"

namespace penpose::decode {

/// The axis and the value of a sample that a role sets.
struct AxisOfRole {
  PenRole role;
  Axis PenAxes::*axis;
  std::int32_t PenSample::*value;
};

/// Null for a control that is no axis.
[[nodiscard]] const AxisOfRole* find_axis(PenRole role);

/// Takes over the range and unit of a control's field, unless the axes have one already or the control is no axis.
void note_axis(PenAxes& axes, PenRole role, const hid::Field& field);

/// Finds the device's axes among those of its reports, and how the reports' own ranges lead to them. Distances stay in
/// their own range.
void unite_axes(PenLayout& layout);

/// Takes over a size (mm, 0: unknown) where the axes tell none or one that no tablet has; if that is unknown as well,
/// of what the axes tell only the proportions stay, as far as a tablet can have them.
void correct_size(PenAxes& axes, double width_mm, double height_mm);

}  // namespace penpose::decode
