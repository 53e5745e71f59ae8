#include "firmware_io/event/event_encoder.h"

#include <algorithm>
#include <cstdint>
#include <linux/input-event-codes.h>
#include <utility>

#include "firmware_io/event/internal/event_layout.h"

namespace penpose::event {
namespace {

constexpr std::int32_t k_palm = 2;  // MT_TOOL_PALM of linux/input.h

std::uint32_t key_of(std::uint16_t type, std::uint16_t code) { return std::uint32_t{type} << 16 | code; }

void write(std::vector<std::uint8_t>& report, const PlacedControl& control, std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(std::clamp(value, control.minimum, control.maximum));
  for (std::uint32_t i = 0; i < control.bit_size; ++i) {
    const std::uint32_t at = control.bit_offset + i;
    if ((bits >> i & 1) != 0) report[at / 8] = static_cast<std::uint8_t>(report[at / 8] | 1u << at % 8);
  }
}

}  // namespace

EventEncoder::EventEncoder(const EventAxes& axes)
    : layout_(base::make_hidden<const EventLayout>(make_event_layout(axes))), fingers_(layout_->slots) {
  for (const PlacedReport* report : {&layout_->pen, &layout_->puck, &layout_->pad}) {
    for (const PlacedControl& control : report->controls) {
      if (control.code == 0 && control.type == EV_KEY) continue;
      Value& value = values_[key_of(control.type, control.code)];
      (report == &layout_->pad ? value.of_pad : value.of_pen) = true;
      const auto range = axes.abs.find(control.code);
      const bool starts_above = control.type == EV_ABS && range != axes.abs.end() && range->second.minimum > 0;
      value.now = starts_above ? range->second.minimum : 0;
    }
  }
  for (const auto* tools : {&layout_->pen_tools, &layout_->puck_tools}) {
    for (const std::uint16_t tool : *tools) values_[key_of(EV_KEY, tool)].of_pen = true;
  }
  if (layout_->pen.length != 0 && axes.has_key(BTN_TOUCH)) values_[key_of(EV_KEY, BTN_TOUCH)].of_pen = true;
}

std::int32_t EventEncoder::value_of(std::uint16_t type, std::uint16_t code) const {
  const auto found = values_.find(key_of(type, code));
  return found == values_.end() ? 0 : found->second.now;
}

EventEncoder::Kind EventEncoder::tool_in_range() const {
  const auto any = [this](const std::vector<std::uint16_t>& tools) {
    return std::any_of(tools.begin(), tools.end(), [this](std::uint16_t tool) { return value_of(EV_KEY, tool) != 0; });
  };
  if (any(layout_->pen_tools)) return Kind::pen;
  return any(layout_->puck_tools) ? Kind::puck : Kind::none;
}

bool EventEncoder::store_finger(const Event& event) {
  if (fingers_.empty()) return false;
  if (event.code == ABS_MT_SLOT) {
    slot_ = event.value < 0 ? fingers_.size() : static_cast<std::size_t>(event.value);
    return true;
  }
  if (slot_ >= fingers_.size()) return true;
  Finger& finger = fingers_[slot_];
  switch (event.code) {
    case ABS_MT_TRACKING_ID:
      finger.replaced = finger.replaced || (event.value >= 0 && finger.was_on);
      finger.on = event.value >= 0;
      finger.palm = false;
      break;
    case ABS_MT_TOOL_TYPE:
      finger.palm = event.value == k_palm;
      break;
    case ABS_MT_POSITION_X:
      finger.x = event.value;
      break;
    case ABS_MT_POSITION_Y:
      finger.y = event.value;
      break;
    default:
      return false;
  }
  fingers_changed_ = true;
  return true;
}

bool EventEncoder::store(const Event& event) {
  if (event.type == EV_ABS && event.code >= ABS_MT_SLOT && event.code <= ABS_MT_TOOL_Y) return store_finger(event);
  const auto found = values_.find(key_of(event.type, event.code));
  if (found == values_.end()) return false;
  Value& value = found->second;
  const std::int64_t sum = event.type == EV_REL ? std::int64_t{value.now} + event.value : event.value;
  value.now = static_cast<std::int32_t>(std::clamp<std::int64_t>(sum, INT32_MIN, INT32_MAX));
  pen_changed_ = pen_changed_ || value.of_pen;
  pad_changed_ = pad_changed_ || value.of_pad;
  return true;
}

void EventEncoder::begin_with(const Event& event) {
  store(event);
  last_tool_ = tool_in_range();
  for (Finger& finger : fingers_) finger.replaced = false;
  pen_changed_ = pad_changed_ = fingers_changed_ = false;
}

std::span<const std::vector<std::uint8_t>> EventEncoder::take(const Event& event) {
  reports_.clear();
  if (event.type != EV_SYN) {
    if (!dropped_) store(event);
    return reports_;
  }
  if (event.code == SYN_DROPPED) dropped_ = true;
  if (event.code != SYN_REPORT) return reports_;
  if (std::exchange(dropped_, false)) return reports_;
  end_frame();
  return reports_;
}

void EventEncoder::end_frame() {
  if (std::exchange(pen_changed_, false)) encode_pen();
  if (std::exchange(pad_changed_, false)) encode_pad();
  if (std::exchange(fingers_changed_, false)) encode_fingers();
}

void EventEncoder::begin_report(std::uint8_t id, std::size_t length) {
  reports_.emplace_back(length);
  reports_.back()[0] = id;
}

void EventEncoder::encode_pen() {
  const Kind tool = tool_in_range();
  const auto encode = [&](Kind kind, bool near) {
    const PlacedReport& report = kind == Kind::puck ? layout_->puck : layout_->pen;
    if (report.length == 0) return;
    begin_report(report.id, report.length);
    const bool erases = near && kind == Kind::pen && value_of(EV_KEY, BTN_TOOL_RUBBER) != 0;
    const bool touches = value_of(EV_KEY, BTN_TOUCH) != 0;
    for (const PlacedControl& control : report.controls) {
      std::int64_t value = 0;
      switch (control.from) {
        case From::state:
          value = value_of(control.type, control.code);
          break;
        case From::number:
          value = static_cast<std::uint32_t>(value_of(control.type, control.code));
          break;
        case From::near:
          value = near ? 1 : 0;
          break;
        case From::eraser:
          value = erases ? 1 : 0;
          break;
        case From::pen_touch:
          value = touches && !erases ? 1 : 0;
          break;
        case From::erase:
          value = touches && erases ? 1 : 0;
          break;
        case From::on_ring:
          break;
      }
      write(reports_.back(), control, value);
    }
  };
  // One that gave way to the other within a frame leaves first.
  if (last_tool_ != Kind::none && tool != Kind::none && tool != last_tool_) encode(last_tool_, false);
  if (tool != Kind::none) {
    encode(tool, true);
  } else {
    encode(last_tool_ == Kind::none && layout_->pen.length == 0 ? Kind::puck : last_tool_, false);
  }
  last_tool_ = tool;
}

/// Wacom's driver has another value than 0 there while anything is touched or held, and a ring at its first place has
/// none. While a key is held, a ring there counts as let go.
bool EventEncoder::is_on_ring() const {
  if (value_of(EV_ABS, ABS_WHEEL) != 0 || value_of(EV_ABS, ABS_THROTTLE) != 0) return true;
  const auto& controls = layout_->pad.controls;
  return value_of(EV_ABS, ABS_MISC) != 0 && std::none_of(controls.begin(), controls.end(), [&](const auto& control) {
           return control.type == EV_KEY && value_of(EV_KEY, control.code) != 0;
         });
}

void EventEncoder::encode_pad() {
  begin_report(layout_->pad.id, layout_->pad.length);
  for (const PlacedControl& control : layout_->pad.controls) {
    const bool finger = control.from == From::on_ring;
    write(reports_.back(), control, finger ? (is_on_ring() ? 1 : 0) : value_of(control.type, control.code));
    // Turns are those of one frame.
    if (control.type == EV_REL) values_[key_of(EV_REL, control.code)].now = 0;
  }
}

void EventEncoder::encode_fingers() {
  const auto encode = [&](bool before) {
    begin_report(layout_->touch.id, layout_->touch.length);
    std::vector<std::uint8_t>& report = reports_.back();
    std::size_t count = 0;
    for (std::size_t i = 0; i < fingers_.size() && count < layout_->fingers.size(); ++i) {
      const Finger& finger = fingers_[i];
      const bool on = before ? finger.was_on && !finger.replaced : finger.on && !finger.palm;
      if (!on && !finger.was_on) continue;
      const PlacedFinger& to = layout_->fingers[count++];
      write(report, to.tip, on ? 1 : 0);
      write(report, to.id, static_cast<std::int64_t>(i));
      write(report, to.x, finger.x);
      write(report, to.y, finger.y);
    }
    write(report, layout_->finger_count, static_cast<std::int64_t>(count));
    return count != 0;
  };
  const bool replaced =
      std::any_of(fingers_.begin(), fingers_.end(), [](const Finger& finger) { return finger.replaced; });
  if (replaced) {
    encode(true);
    for (Finger& finger : fingers_) finger.was_on = finger.was_on && !finger.replaced;
  }
  if (!encode(false)) reports_.pop_back();
  for (Finger& finger : fingers_) {
    finger.was_on = finger.on && !finger.palm;
    finger.replaced = false;
  }
}

}  // namespace penpose::event
