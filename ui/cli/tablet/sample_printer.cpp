#include "ui/cli/tablet/sample_printer.h"

#include <array>
#include <charconv>
#include <string_view>
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

template <typename T>
void append(std::string& out, T number) {
  std::array<char, 24> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  out.append(text.data(), end);
}

std::string_view name_of(Tool tool) {
  switch (tool) {
    case Tool::none:
      return "";
    case Tool::pen:
      return "pen";
    case Tool::eraser:
      return "eraser";
    case Tool::mouse:
      return "mouse";
  }
  return "";
}

void append_cell(std::string& out, const Axis& axis, std::int32_t value) {
  if (axis.present) append(out, value);
  out += ',';
}

void append_flag(std::string& out, bool flag) { out += flag ? '1' : '0'; }

}  // namespace

void append_csv_axes(std::string& out, const PenAxes& axes) {
  for (const auto& [name, axis] : named(axes)) {
    if (!axis->present) continue;
    out += "# axis ";
    out += name;
    out += ' ';
    append(out, axis->minimum);
    out += ' ';
    append(out, axis->maximum);
    out += ' ';
    out += base::format_double(axis->units_per_mm);
    out += '\n';
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
  append(out, printed.report);
  out += ',';
  append(out, printed.time_us);
  out += ',';
  append(out, sample.x);
  out += ',';
  append(out, sample.y);
  out += ',';
  append_cell(out, axes.pressure, sample.pressure);
  append_cell(out, axes.tilt_x, sample.tilt_x);
  append_cell(out, axes.tilt_y, sample.tilt_y);
  append_cell(out, axes.distance, sample.distance);
  append_flag(out, sample.in_range);
  out += ',';
  out += name_of(sample.tool);
  out += ',';
  append_flag(out, sample.tip);
  out += ',';
  append_flag(out, (sample.buttons & 1) != 0);
  out += ',';
  append_flag(out, (sample.buttons & 2) != 0);
  if (with_device) {
    out += ',';
    append(out, printed.device);
  }
  out += '\n';
}

void append_json_axes(std::string& out, const PenAxes& axes) {
  bool first = true;
  for (const auto& [name, axis] : named(axes)) {
    if (!axis->present) continue;
    if (!first) out += ", ";
    first = false;
    out += '"';
    out += name;
    out += "\": {\"min\": ";
    append(out, axis->minimum);
    out += ", \"max\": ";
    append(out, axis->maximum);
    out += ", \"units_per_mm\": ";
    out += base::format_double(axis->units_per_mm);
    out += '}';
  }
}

void append_json_sample(std::string& out, const PrintedSample& printed) {
  const PenSample& sample = *printed.sample;
  const PenAxes& axes = *printed.axes;
  const auto member = [&](std::string_view name, auto value) {
    out += ", \"";
    out += name;
    out += "\": ";
    append(out, value);
  };
  const auto flag = [&](std::string_view name, bool value) {
    out += ", \"";
    out += name;
    out += value ? "\": true" : "\": false";
  };
  out += "\"report\": ";
  append(out, printed.report);
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
    out += '"';
    out += name_of(sample.tool);
    out += '"';
  }
  flag("tip", sample.tip);
  member("buttons", sample.buttons);
  member("tool_id", sample.tool_id);
  member("serial", sample.serial);
}

}  // namespace penpose::cli
