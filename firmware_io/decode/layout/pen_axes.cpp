#include "firmware_io/decode/layout/pen_axes.h"

#include <algorithm>
#include <array>
#include <limits>

namespace penpose::decode {
namespace {

using hid::Field;

constexpr auto k_axes =
    std::to_array<Axis PenAxes::*>({&PenAxes::x, &PenAxes::y, &PenAxes::pressure, &PenAxes::tilt_x, &PenAxes::tilt_y,
                                    &PenAxes::distance, &PenAxes::rotation, &PenAxes::wheel});

constexpr auto k_axis_of_role =
    std::to_array<AxisOfRole>({{PenRole::x, &PenAxes::x, &PenSample::x},
                               {PenRole::y, &PenAxes::y, &PenSample::y},
                               {PenRole::pressure, &PenAxes::pressure, &PenSample::pressure},
                               {PenRole::height_down, &PenAxes::distance, &PenSample::distance},
                               {PenRole::distance, &PenAxes::distance, &PenSample::distance},
                               {PenRole::tilt_x, &PenAxes::tilt_x, &PenSample::tilt_x},
                               {PenRole::tilt_y, &PenAxes::tilt_y, &PenSample::tilt_y},
                               {PenRole::twist, &PenAxes::rotation, &PenSample::rotation},
                               {PenRole::wheel, &PenAxes::wheel, &PenSample::wheel}});

double units_of(PenRole role, const Field& field) {
  switch (role) {
    case PenRole::pressure:
    case PenRole::wheel:
      return 0;
    case PenRole::tilt_x:
    case PenRole::tilt_y:
    case PenRole::twist:
      return hid::units_per_degree(field);
    default:
      return hid::units_per_mm(field);
  }
}

std::int32_t narrow(std::int64_t value) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(value, std::numeric_limits<std::int32_t>::min(),
                                                            std::numeric_limits<std::int32_t>::max()));
}

}  // namespace

const AxisOfRole* find_axis(PenRole role) {
  const auto found = std::find_if(k_axis_of_role.begin(), k_axis_of_role.end(),
                                  [role](const AxisOfRole& one) { return one.role == role; });
  return found == k_axis_of_role.end() ? nullptr : &*found;
}

void note_axis(PenAxes& axes, PenRole role, const Field& field) {
  const AxisOfRole* const found = find_axis(role);
  if (found == nullptr || (axes.*found->axis).present) return;
  axes.*found->axis = {narrow(field.logical_minimum), narrow(field.logical_maximum), units_of(role, field), true};
}

void unite_axes(PenLayout& layout) {
  const auto is_read = [&](const PenReport& report) { return layout.report_of_id[report.id] >= 0; };
  const auto span = [](const Axis& axis) { return std::int64_t{axis.maximum} - axis.minimum; };
  const PenReport* finest = nullptr;
  for (const PenReport& report : layout.reports) {
    if (!is_read(report)) continue;
    const auto finer = [&](Axis PenAxes::*axis) { return span(report.axes.*axis) - span(finest->axes.*axis); };
    // Of two that are as fine, the last: it is the tablet's own form, behind that of Windows Ink.
    if (finest == nullptr || finer(&PenAxes::x) > 0 || (finer(&PenAxes::x) == 0 && finer(&PenAxes::pressure) >= 0)) {
      finest = &report;
    }
  }
  if (finest == nullptr) return;
  layout.axes = finest->axes;
  for (Axis PenAxes::*axis : k_axes) {
    for (const PenReport& report : layout.reports) {
      if (!(layout.axes.*axis).present && is_read(report)) layout.axes.*axis = report.axes.*axis;
    }
  }
  for (PenReport& report : layout.reports) {
    for (PenControl& control : report.controls) {
      const AxisOfRole* const found = find_axis(control.role);
      if (found == nullptr || found->axis == &PenAxes::distance) continue;
      control.lead_to(report.axes.*found->axis, layout.axes.*found->axis);
    }
  }
}

void correct_size(PenAxes& axes, double width_mm, double height_mm) {
  constexpr double k_least_mm = 20.0;
  constexpr double k_most_mm = 1000.0;
  constexpr double k_most_uneven = 5.0;
  const auto span = [](const Axis& axis) { return static_cast<double>(axis.maximum) - axis.minimum; };
  const auto told_mm = [&](const Axis& axis) { return axis.units_per_mm > 0 ? span(axis) / axis.units_per_mm : 0; };
  const double width = told_mm(axes.x);
  const double height = told_mm(axes.y);
  const bool uneven = width > k_most_uneven * height || height > k_most_uneven * width;
  if (!uneven && std::min(width, height) >= k_least_mm && std::max(width, height) <= k_most_mm) return;
  const bool known = width_mm > 0 && height_mm > 0;
  if (known || uneven) {
    axes.x.units_per_mm = known ? span(axes.x) / width_mm : 0;
    axes.y.units_per_mm = known ? span(axes.y) / height_mm : 0;
  }
}

}  // namespace penpose::decode
