#include "firmware_io/decode/hand/pen_mapping.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penpose::decode {
namespace {

base::Error unusable(const char* what, const char* remedy) { return {std::string("pen mapping: ") + what, "", remedy}; }

/// Units per degree where a device states none: the usual ranges are either degrees or a finer division of 90 of them.
double tilt_density(const Axis& axis) {
  if (axis.units_per_mm > 0) return axis.units_per_mm;
  return axis.maximum > 90 ? axis.maximum / 90.0 : 1;
}

}  // namespace

double PenMapping::Span::fraction(double value) const { return std::clamp((value - start) / (end - start), 0.0, 1.0); }

base::Result<PenMapping> PenMapping::make(const PenAxes& axes, PenMappingOptions options) {
  const bool has_picture = options.width_px > 0 && options.height_px > 0 && std::isfinite(options.width_px) &&
                           std::isfinite(options.height_px);
  if (!has_picture) return unusable("the picture has no size", "give a width and a height above 0");
  if (axes.x.maximum <= axes.x.minimum || axes.y.maximum <= axes.y.minimum) {
    return unusable("the range of the position is not known",
                    "name the tablet's protocol or add the tablet to the table");
  }
  const TabletArea area = options.area.value_or(TabletArea{});
  const bool inside = area.left >= 0 && area.top >= 0 && area.right <= 1 && area.bottom <= 1;
  if (!inside || !(area.left < area.right) || !(area.top < area.bottom)) {
    return unusable("the area is empty or reaches beyond the tablet", "give fractions from 0 to 1");
  }

  PenMapping mapping;
  const auto part = [](const Axis& axis, double from, double to) {
    const double range = static_cast<double>(axis.maximum) - axis.minimum;
    return Span{axis.minimum + from * range, axis.minimum + to * range};
  };
  mapping.x_ = part(axes.x, area.left, area.right);
  mapping.y_ = part(axes.y, area.top, area.bottom);
  mapping.turns_ = ((options.quarter_turns + (options.left_handed ? 2 : 0)) % 4 + 4) % 4;

  if (options.keep_aspect) {
    const bool known = axes.x.units_per_mm > 0 && axes.y.units_per_mm > 0;
    const double width = (mapping.x_.end - mapping.x_.start) / (known ? axes.x.units_per_mm : 1);
    const double height = (mapping.y_.end - mapping.y_.start) / (known ? axes.y.units_per_mm : 1);
    double wanted = options.width_px / options.height_px;  // width by height, as the tablet sees it
    if (mapping.turns_ % 2 == 1) wanted = 1 / wanted;
    const auto shrink = [](Span& span, double factor) {
      const double middle = (span.start + span.end) / 2;
      const double half = (span.end - span.start) / 2 * factor;
      span = {middle - half, middle + half};
    };
    if (width > height * wanted) {
      shrink(mapping.x_, height * wanted / width);
    } else {
      shrink(mapping.y_, width / wanted / height);
    }
  }
  mapping.pressure_axis_ = axes.pressure;
  mapping.units_per_degree_x_ = tilt_density(axes.tilt_x);
  mapping.units_per_degree_y_ = tilt_density(axes.tilt_y);
  mapping.options_ = std::move(options);
  return mapping;
}

MappedSample PenMapping::map(const PenSample& sample) const {
  MappedSample mapped;
  double u = x_.fraction(sample.x);
  double v = y_.fraction(sample.y);
  double tilt_x = sample.tilt_x / units_per_degree_x_;
  double tilt_y = sample.tilt_y / units_per_degree_y_;
  // One clockwise turn brings the tablet's right edge to the bottom.
  for (int turn = 0; turn < turns_; ++turn) {
    u = std::exchange(v, u);
    u = 1 - u;
    tilt_x = std::exchange(tilt_y, tilt_x);
    tilt_x = -tilt_x;
  }
  mapped.x_px = u * options_.width_px;
  mapped.y_px = v * options_.height_px;
  mapped.tilt_x_degrees = tilt_x;
  mapped.tilt_y_degrees = tilt_y;
  const double range = static_cast<double>(pressure_axis_.maximum) - pressure_axis_.minimum;
  // A device without pressure is fully pressed or not at all.
  const double pressed =
      range > 0 ? (sample.pressure - static_cast<double>(pressure_axis_.minimum)) / range : (sample.tip ? 1.0 : 0.0);
  mapped.pressure = options_.pressure(pressed);
  mapped.tool = sample.tool;
  mapped.in_range = sample.in_range;
  mapped.tip = sample.tip;
  mapped.buttons = sample.buttons;
  return mapped;
}

}  // namespace penpose::decode
