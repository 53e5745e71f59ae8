#include "firmware_io/decode/wacom/wacom_axes.h"

namespace penpose::decode {

PenAxes wacom_axes(const WacomModel& model) {
  PenAxes axes;
  axes.x = {model.margin, model.max_x - model.margin, static_cast<double>(model.units_per_mm), true};
  const std::int32_t units_y = model.units_per_mm_y > 0 ? model.units_per_mm_y : model.units_per_mm;
  axes.y = {model.margin, model.max_y - model.margin, static_cast<double>(units_y), true};
  axes.pressure = {0, model.max_pressure, 0, true};
  if (model.max_distance > 0) axes.distance = {0, model.max_distance, 0, true};
  return axes;
}

void add_wacom_tilt(PenAxes& axes) {
  axes.tilt_x = {-64, 63, 1, true};
  axes.tilt_y = {-64, 63, 1, true};
}

void add_wacom_rotation_and_wheel(PenAxes& axes, bool rotation) {
  if (rotation) axes.rotation = {-900, 899, 5, true};
  axes.wheel = {0, 1023, 0, true};
}

}  // namespace penpose::decode
