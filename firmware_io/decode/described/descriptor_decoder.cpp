#include "firmware_io/decode/described/descriptor_decoder.h"

#include <algorithm>

#include "firmware_io/decode/layout/pen_axes.h"

namespace penpose::decode {

DescriptorDecoder::DescriptorDecoder(PenLayout layout) : layout_(std::move(layout)) {
  for (PenReport& report : layout_.reports) {
    std::stable_sort(report.controls.begin(), report.controls.end(),
                     [](const PenControl& a, const PenControl& b) { return a.role < b.role; });
  }
  proximity_.resize(layout_.reports.size());
}

void DescriptorDecoder::reset() {
  sample_ = {};
  std::fill(proximity_.begin(), proximity_.end(), Proximity{});
}

ReportKind DescriptorDecoder::decode(base::Bytes raw) {
  const PenReport* const report = layout_.find(raw);
  if (report == nullptr) return ReportKind::ignored;
  const bool was_in_range = sample_.in_range;
  Proximity& proximity = proximity_[static_cast<std::size_t>(report - layout_.reports.data())];
  for (const PenControl& control : report->controls) {
    std::int64_t value = control.value(raw);
    if (control.minimum < control.maximum) {
      if (control.null_state && (value < control.minimum || value > control.maximum)) continue;
      value = std::clamp(value, control.minimum, control.maximum);
    }
    apply(*report, control, value, proximity);
  }
  if (!report->has_proximity) {
    // Nothing says whether the pen is near, but it sends reports only while it is.
    if (proximity.tool == Tool::none) take(Tool::pen, proximity);
    proximity.active = false;
  }
  sample_.in_range = sample_.tool != Tool::none;
  return sample_.in_range || was_in_range ? ReportKind::pen : ReportKind::ignored;
}

void DescriptorDecoder::release(Tool tool, Proximity& proximity) {
  if (tool == Tool::none || sample_.tool != tool) return;
  sample_.tip = false;
  sample_.tool = Tool::none;
  proximity.tool = Tool::none;
}

void DescriptorDecoder::take(Tool tool, Proximity& proximity) {
  if (proximity.tool != tool) release(proximity.tool, proximity);
  sample_.tool = tool;
  proximity.tool = tool;
}

void DescriptorDecoder::press(unsigned button, bool down) {
  const std::uint32_t mask = 1u << button;
  sample_.buttons = down ? sample_.buttons | mask : sample_.buttons & ~mask;
}

void DescriptorDecoder::apply(const PenReport& report, const PenControl& control, std::int64_t value,
                              Proximity& proximity) {
  const bool on = value != 0;
  // Linux's hid-input passes on every axis as it is, Z too.
  if (const AxisOfRole* const axis = find_axis(control.role))
    sample_.*axis->value = static_cast<std::int32_t>(control.scaled(value));
  switch (control.role) {
    case PenRole::eraser:
      proximity.active = proximity.active || on;
      if (on) {
        take(Tool::eraser, proximity);
        sample_.tip = true;
        proximity.erasing = true;
      } else if (proximity.tool == Tool::eraser) {
        // Where no Invert says that the pen was turned round again, the second report without Eraser does.
        if (!report.has_invert && !proximity.erasing) release(Tool::eraser, proximity);
        sample_.tip = false;
        proximity.erasing = false;
      }
      return;
    case PenRole::invert:
      proximity.active = proximity.active || on;
      if (on) {
        take(Tool::eraser, proximity);
      } else if (!proximity.active) {
        release(Tool::eraser, proximity);
      }
      return;
    case PenRole::tip:
      proximity.active = proximity.active || on;
      if (proximity.tool != Tool::eraser) sample_.tip = on;
      return;
    case PenRole::pressure:
      // An eraser that is a button of the pen can be held in the air.
      if (proximity.tool == Tool::eraser && value <= control.minimum) sample_.tip = false;
      if (!report.has_tip) {
        const bool pressed = value > control.minimum + ((control.maximum - control.minimum) >> 3);
        proximity.active = proximity.active || pressed;
        if (proximity.tool != Tool::eraser) sample_.tip = pressed;
      }
      return;
    case PenRole::in_range: {
      const Tool mine = report.is_puck ? Tool::mouse : Tool::pen;
      proximity.active = proximity.active || on;
      if (proximity.active) {
        take(proximity.tool == Tool::none ? mine : proximity.tool, proximity);
      } else {
        release(proximity.tool, proximity);
      }
      proximity.active = false;
      return;
    }
    case PenRole::barrel:
      return press(0, on);
    case PenRole::barrel2:
      return press(1, on);
    case PenRole::barrel3:
      return press(2, on);
    case PenRole::serial:
      sample_.serial = (sample_.serial & ~0xffffffffull) | static_cast<std::uint32_t>(value);
      return;
    case PenRole::serial_high:
      sample_.serial = (sample_.serial & 0xffffffffull) | (static_cast<std::uint64_t>(value) << 32);
      return;
    case PenRole::tool_type:
      sample_.tool_id = static_cast<std::uint32_t>(value);
      return;
    default:  // an axis, or nothing that such pens say
      return;
  }
}

}  // namespace penpose::decode
