#include "firmware_io/decode/wacom/wacom_generic_decoder.h"

#include <algorithm>

#include "firmware_io/decode/layout/pen_axes.h"

namespace penpose::decode {

namespace {

/// The pen's rotation is 0 with its buttons at the top for the tablet, at the left for programs.
std::int64_t quarter_turned(const PenControl& control, std::int64_t value) {
  const std::int64_t turn = control.maximum - control.minimum + 1;
  value += turn / 4;
  return value > control.maximum ? value - turn : value;
}

/// What a control tells of the tool's number.
std::uint32_t tool_number_in(PenRole role, std::int64_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  // Electromagnetic pens keep the part that does not fit its own field above their serial number.
  const bool tells = role == PenRole::tool_type || (role == PenRole::serial_high && bits >> 20 == 1);
  return tells ? bits & 0xfffff : 0;
}

}  // namespace

WacomGenericDecoder::WacomGenericDecoder(PenLayout layout) : layout_(std::move(layout)) {}

void WacomGenericDecoder::reset() {
  sample_ = {};
  tool_ = WacomTool::none;
  tool_number_ = 0;
  serial_ = 0;
  waited_ = 0;
  in_range_ = sensed_ = turned_ = tip_ = false;
  barrels_ = {};
  invalid_frame_ = was_sensed_ = false;
  frames_.clear();
}

bool WacomGenericDecoder::waits_for_serial(const PenReport& report, base::Bytes raw) {
  if (serial_ != 0 || !report.has_serial || waited_ >= k_longest_wait) return false;
  bool unknown = false;
  for (const PenControl& control : report.controls) {
    const bool identifies =
        control.role == PenRole::serial || control.role == PenRole::serial_high || control.role == PenRole::tool_type;
    if (!identifies && control.role != PenRole::in_range) continue;
    const bool on = control.value(raw) != 0;
    if (control.role == PenRole::in_range ? !on : on) return false;
    unknown = true;
  }
  if (unknown) ++waited_;
  return unknown;
}

std::uint32_t WacomGenericDecoder::identified(const PenReport& report, base::Bytes raw) const {
  std::uint32_t number = tool_number_;
  for (const PenControl& control : report.controls) number |= tool_number_in(control.role, control.value(raw));
  return number;
}

ReportKind WacomGenericDecoder::decode(base::Bytes raw) {
  const PenReport* const report = layout_.find(raw);
  if (report == nullptr || waits_for_serial(*report, raw)) return ReportKind::ignored;
  frames_.clear();
  invalid_frame_ = false;
  rotates_ = report->has_twist && is_art_pen(identified(*report, raw));
  std::int32_t collection = report->controls.front().collection;
  for (const PenControl& control : report->controls) {
    if (control.collection != collection) end_frame(*report);
    collection = control.collection;
    const std::int64_t value = control.value(raw);
    if (value >= control.minimum && value <= control.maximum) apply(*report, control, control.scaled(value));
  }
  end_frame(*report);
  return frames_.empty() ? ReportKind::ignored : ReportKind::pen;
}

void WacomGenericDecoder::set_axis(std::int32_t& axis, std::int64_t value) {
  if (in_range_) {
    axis = static_cast<std::int32_t>(value);
  } else if (was_sensed_ && !sensed_) {
    axis = 0;
  }
}

void WacomGenericDecoder::apply(const PenReport& report, const PenControl& control, std::int64_t value) {
  if (invalid_frame_) return;
  const bool on = value != 0;
  switch (control.role) {
    case PenRole::in_range:
      in_range_ = on;
      if (!report.has_sense) sensed_ = on;
      return;
    case PenRole::sense:
      sensed_ = on;
      return;
    case PenRole::invert:
      turned_ = turned_ || on;
      return;
    case PenRole::eraser:  // Invert alone says that the pen is turned round
    case PenRole::tip:
      tip_ = tip_ || on;
      return;
    case PenRole::barrel:
    case PenRole::barrel2:
    case PenRole::barrel3:
      barrels_[static_cast<std::size_t>(control.role) - static_cast<std::size_t>(PenRole::barrel)] = on;
      return;
    case PenRole::serial:
      if (on) serial_ = (serial_ & ~0xffffffffull) | static_cast<std::uint32_t>(value);
      return;
    case PenRole::serial_high:
      if (on) {
        serial_ = (serial_ & 0xffffffffull) | (static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)) << 32);
      }
      tool_number_ |= tool_number_in(control.role, value);
      return;
    case PenRole::tool_type:
      tool_number_ |= tool_number_in(control.role, value);
      return;
    case PenRole::report_valid:
      invalid_frame_ = !on;
      return;
    case PenRole::height_down:
      return set_axis(sample_.distance, control.maximum - value);
    case PenRole::twist:
      // Others than art pens send meaningless bits there.
      if (rotates_) set_axis(sample_.rotation, quarter_turned(control, value));
      return;
    default:
      if (const AxisOfRole* const axis = find_axis(control.role)) set_axis(sample_.*axis->value, value);
  }
}

void WacomGenericDecoder::end_frame(const PenReport& report) {
  if (invalid_frame_) return;
  if (tool_ == WacomTool::none && in_range_) {
    if (turned_) {
      tool_ = WacomTool::eraser;
    } else if (layout_.aes || tool_number_ == 0) {
      tool_ = WacomTool::pen;
    } else {
      tool_ = wacom_tool(tool_number_);
    }
  }
  was_sensed_ = sensed_;
  if (tool_ != WacomTool::none) {
    std::uint32_t buttons = 0;
    if (barrels_[0] && barrels_[1] && report.both_are_third) {
      buttons = 1u << 2;
    } else {
      for (unsigned i = 0; i < barrels_.size(); ++i) buttons |= (barrels_[i] ? 1u : 0u) << i;
    }
    sample_.buttons = buttons;
    sample_.tip = tip_;
    sample_.in_range = sensed_;
    sample_.tool = sensed_ ? tool_of(tool_) : Tool::none;
    sample_.serial = serial_;
    sample_.tool_id = sensed_ ? (serial_ >> 52 == 1 ? wacom_tool_id(tool_number_) : tool_number_) : 0;
    tip_ = false;
    turned_ = false;
    frames_.add(sample_);
  }
  if (!sensed_) {
    tool_ = WacomTool::none;
    tool_number_ = 0;
    serial_ = 0;
    waited_ = 0;
  }
}

}  // namespace penpose::decode
