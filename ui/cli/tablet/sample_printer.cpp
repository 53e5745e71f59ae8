#include "ui/cli/tablet/sample_printer.h"

#include <array>
#include <charconv>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/base/numbers.h"

namespace penpose::cli {
namespace {

using decode::Axis;
using decode::PenAxes;
using decode::PenSample;
using decode::Tool;

constexpr std::size_t k_axes = 8;

std::array<std::pair<std::string_view, const Axis*>, k_axes> named(const PenAxes& axes) {
  return {{{"x", &axes.x},
           {"y", &axes.y},
           {"pressure", &axes.pressure},
           {"tilt_x", &axes.tilt_x},
           {"tilt_y", &axes.tilt_y},
           {"distance", &axes.distance},
           {"rotation", &axes.rotation},
           {"wheel", &axes.wheel}}};
}

/// Texts as they are, and integers.
template <typename... Parts>
void append(std::string& out, const Parts&... parts) {
  const auto one = [&out](const auto& part) {
    if constexpr (std::is_integral_v<std::decay_t<decltype(part)>>) {
      std::array<char, 24> text;
      const auto end = std::to_chars(text.data(), text.data() + text.size(), part).ptr;
      out.append(text.data(), end);
    } else {
      out += part;
    }
  };
  (one(parts), ...);
}

std::string_view name_of(Tool tool) {
  constexpr std::string_view k_names[] = {"", "pen", "eraser", "mouse"};
  return k_names[static_cast<std::size_t>(tool)];
}

void append_cell(std::string& out, const Axis& axis, std::int32_t value) {
  if (axis.present) append(out, value);
  out += ',';
}

std::string_view digit(bool flag) { return flag ? "1" : "0"; }

}  // namespace

void append_csv_axes(std::string& out, const PenAxes& axes) {
  for (const auto& [name, axis] : named(axes)) {
    if (!axis->present) continue;
    append(out, "# axis ", name, " ", axis->minimum, " ", axis->maximum, " ", base::format_double(axis->units_per_mm),
           "\n");
  }
}

void append_csv_header(std::string& out, const PenAxes& axes, bool with_device) {
  append_csv_axes(out, axes);
  out += "report,time_us,x,y,pressure,tilt_x,tilt_y,distance,in_range,tool,tip,button1,button2";
  out += with_device ? ",device\n" : "\n";
}

void append_csv_row(std::string& out, const PrintedSample& printed, bool with_device) {
  const PenSample& sample = *printed.sample;
  const PenAxes& axes = *printed.axes;
  append(out, printed.report, ",", printed.time_us, ",", sample.x, ",", sample.y, ",");
  append_cell(out, axes.pressure, sample.pressure);
  append_cell(out, axes.tilt_x, sample.tilt_x);
  append_cell(out, axes.tilt_y, sample.tilt_y);
  append_cell(out, axes.distance, sample.distance);
  append(out, digit(sample.in_range), ",", name_of(sample.tool), ",", digit(sample.tip), ",",
         digit((sample.buttons & 1) != 0), ",", digit((sample.buttons & 2) != 0));
  if (with_device) append(out, ",", printed.device);
  out += '\n';
}

void append_json_axes(std::string& out, const PenAxes& axes) {
  bool first = true;
  for (const auto& [name, axis] : named(axes)) {
    if (!axis->present) continue;
    append(out, first ? "\"" : ", \"", name, "\": {\"min\": ", axis->minimum, ", \"max\": ", axis->maximum,
           ", \"units_per_mm\": ", base::format_double(axis->units_per_mm), "}");
    first = false;
  }
}

void append_json_sample(std::string& out, const PrintedSample& printed) {
  const PenSample& sample = *printed.sample;
  const PenAxes& axes = *printed.axes;
  const auto member = [&](std::string_view name, auto value) { append(out, ", \"", name, "\": ", value); };
  const auto flag = [&](std::string_view name, bool value) {
    append(out, ", \"", name, value ? "\": true" : "\": false");
  };
  append(out, "\"report\": ", printed.report);
  member("time_us", printed.time_us);
  member("device", printed.device);
  member("x", sample.x);
  member("y", sample.y);
  if (axes.pressure.present) member("pressure", sample.pressure);
  if (axes.tilt_x.present) member("tilt_x", sample.tilt_x);
  if (axes.tilt_y.present) member("tilt_y", sample.tilt_y);
  if (axes.distance.present) member("distance", sample.distance);
  if (axes.rotation.present) member("rotation", sample.rotation);
  if (axes.wheel.present) member("wheel", sample.wheel);
  flag("in_range", sample.in_range);
  out += ", \"tool\": ";
  if (sample.tool == Tool::none) {
    out += "null";
  } else {
    append(out, "\"", name_of(sample.tool), "\"");
  }
  flag("tip", sample.tip);
  member("buttons", sample.buttons);
  member("tool_id", sample.tool_id);
  member("serial", sample.serial);
}

}  // namespace penpose::cli
