#include "firmware_io/decode/layout/layout_decoder.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace penpose::decode {
namespace {

std::int32_t read(const std::optional<BitNumber>& field, base::Bytes report, std::int32_t otherwise) {
  return field ? static_cast<std::int32_t>(field->read_or(report, 0)) : otherwise;
}
std::uint32_t read_bits(const std::optional<BitNumber>& field, base::Bytes report, std::uint32_t otherwise) {
  return field ? static_cast<std::uint32_t>(field->read_or(report, 0)) : otherwise;
}

/// The Wacom art pen counts turns in half units either way from a quarter turn; the result is -900..899 as in Linux.
std::int32_t marker_rotation(std::int32_t code) {
  if ((code & 1) == 0) return 450 - code / 2;
  const std::int32_t rotation = (code - 1) / 2 + 450;
  return code > 900 ? rotation - 1800 : rotation;
}

std::uint64_t pressed_keys(const KeyCodes& codes, base::Bytes report) {
  const bool modified = report[codes.modifier_byte] != 0;
  std::uint64_t keys = 0;
  for (const auto code : report.subspan(codes.first_byte)) {
    for (std::size_t i = 0; i < codes.keys.size(); ++i) {
      const auto& key = codes.keys[i];
      const bool fits =
          key.modifiers == KeyCodes::Modifiers::any || modified == (key.modifiers == KeyCodes::Modifiers::some);
      if (key.code == code && fits) keys |= std::uint64_t{1} << i;
    }
  }
  return keys;
}

PenAxes axes_of(const Protocol& protocol, PenAxes axes) {
  axes.x.present = axes.y.present = axes.pressure.present = false;
  axes.tilt_x.present = axes.tilt_y.present = axes.distance.present = false;
  axes.rotation.present = axes.wheel.present = false;
  for (const auto& rule : protocol.rules) {
    const Layout& layout = *rule.layout;
    axes.x.present |= layout.x.has_value();
    axes.y.present |= layout.y.has_value();
    axes.pressure.present |= layout.pressure.has_value();
    axes.tilt_x.present |= layout.tilt_x.has_value();
    axes.tilt_y.present |= layout.tilt_y.has_value();
    axes.distance.present |= layout.distance.has_value();
    axes.rotation.present |= layout.rotation.has_value();
    axes.wheel.present |= layout.wheel.has_value();
  }
  return axes;
}

std::int8_t percent_of(const Layout& layout, base::Bytes report) {
  const std::int64_t value = layout.battery->read(report);
  return static_cast<std::int8_t>(std::clamp<std::int64_t>(value * 100 / layout.battery_full, 0, 100));
}

}  // namespace

LayoutDecoder::LayoutDecoder(std::shared_ptr<const Protocol> protocol, const PenAxes& axes)
    : protocol_(std::move(protocol)), axes_(axes_of(*protocol_, axes)) {}

void LayoutDecoder::reset() {
  sample_ = {};
  pad_ = {};
  memory_ = {};
  told_ = nullptr;
}

ReportKind LayoutDecoder::decode(base::Bytes report) {
  if (report.size() < protocol_->skip) return ReportKind::ignored;
  report = report.subspan(protocol_->skip);
  if (report.size() < protocol_->shortest) return ReportKind::ignored;
  for (const auto& rule : rules_for(report)) {
    if (!rule.when.holds(report)) continue;
    return report.size() < rule.layout->shortest ? ReportKind::ignored : apply(*rule.layout, report);
  }
  return ReportKind::ignored;
}

const std::vector<Protocol::Rule>& LayoutDecoder::rules_for(base::Bytes report) {
  for (const Protocol::Variant& variant : protocol_->variants) {
    if (variant.told_by.holds(report)) told_ = &variant;
  }
  return told_ == nullptr ? protocol_->rules : told_->rules;
}

ReportKind LayoutDecoder::apply(const Layout& layout, base::Bytes report) {
  switch (layout.gives) {
    case Gives::ignored:
      if (layout.battery) pad_.battery = percent_of(layout, report);
      return ReportKind::ignored;
    case Gives::touch:
      return ReportKind::ignored;
    case Gives::pen:
      apply_pen(layout, report);
      return ReportKind::pen;
    case Gives::mouse:
      apply_mouse(layout, report);
      return ReportKind::pen;
    case Gives::tool:
      memory_.tool_id = read_bits(layout.tool_id, report, 0);
      memory_.serial = read_bits(layout.serial, report, 0);
      memory_.tool_is_eraser = layout.eraser && layout.eraser->holds(report);
      return ReportKind::ignored;
    case Gives::leave:
      leave();
      return ReportKind::pen;
    case Gives::pad:
      apply_pad(layout, report);
      return ReportKind::pad;
    case Gives::touch_pad:
      return apply_touch_pad(report) ? ReportKind::pad : ReportKind::ignored;
  }
  return ReportKind::ignored;
}

void LayoutDecoder::leave() {
  PenSample gone;
  gone.x = sample_.x;
  gone.y = sample_.y;
  sample_ = gone;
  memory_.tool_id = 0;
  memory_.serial = 0;
  memory_.tool_is_eraser = false;
  memory_.was_out = true;
}

void LayoutDecoder::apply_position(const Layout& layout, base::Bytes report) {
  sample_.x = read(layout.x, report, sample_.x);
  sample_.y = read(layout.y, report, sample_.y);
  sample_.distance = read(layout.distance, report, sample_.distance);
  sample_.in_range = !layout.near || layout.near->holds(report);
  sample_.serial = memory_.serial;
  sample_.tool_id = memory_.tool_id;
  if (layout.keys) apply_pad(layout, report);
}

void LayoutDecoder::apply_pen(const Layout& layout, base::Bytes report) {
  apply_position(layout, report);
  if (layout.pressure) memory_.pressure = std::max(0, read(layout.pressure, report, 0));
  if (layout.tilt_x) memory_.tilt_x = read(layout.tilt_x, report, 0);
  if (layout.tilt_y) memory_.tilt_y = read(layout.tilt_y, report, 0);
  std::uint32_t buttons = read_bits(layout.buttons, report, 0);
  if (layout.buttons) memory_.buttons = buttons;
  if (layout.last_buttons) buttons = memory_.buttons;
  bool erases = layout.eraser_by_tool ? memory_.tool_is_eraser : layout.eraser && layout.eraser->holds(report);
  if (layout.eraser_button != 0) {
    const std::uint32_t bit = std::uint32_t{1} << (layout.eraser_button - 1);
    if (memory_.was_out) memory_.entered_as_eraser = (buttons & bit) != 0;
    erases = memory_.entered_as_eraser && (buttons & bit) != 0;
    if (memory_.entered_as_eraser) buttons &= ~bit;
  }
  memory_.was_out = false;

  sample_.pressure = layout.pressure || layout.last_pressure ? memory_.pressure : 0;
  sample_.tilt_x = layout.tilt_x || layout.last_tilt ? memory_.tilt_x : 0;
  sample_.tilt_y = layout.tilt_y || layout.last_tilt ? memory_.tilt_y : 0;
  sample_.wheel = read(layout.wheel, report, sample_.wheel);
  if (layout.rotation) {
    const auto raw = read(layout.rotation, report, 0);
    sample_.rotation = layout.rotation_is_marker ? marker_rotation(raw) : raw;
  }
  if (!sample_.in_range) {
    sample_.tool = Tool::none;
    sample_.tip = false;
    sample_.buttons = 0;
    return;
  }
  sample_.tool = erases ? Tool::eraser : Tool::pen;
  sample_.tip = layout.tip ? layout.tip->holds(report) : sample_.pressure > protocol_->tip_above;
  sample_.buttons = buttons;
}

void LayoutDecoder::apply_mouse(const Layout& layout, base::Bytes report) {
  apply_position(layout, report);
  sample_.pressure = 0;
  sample_.tilt_x = 0;
  sample_.tilt_y = 0;
  sample_.rotation = 0;
  sample_.tip = false;
  sample_.tool = sample_.in_range ? Tool::mouse : Tool::none;
  sample_.buttons = sample_.in_range ? read_bits(layout.buttons, report, 0) : 0;
  sample_.wheel = layout.scroll ? static_cast<std::int32_t>(layout.scroll->read(report)) : 0;
}

void LayoutDecoder::apply_pad(const Layout& layout, base::Bytes report) {
  if (layout.keys) pad_.keys = read_bits(layout.keys, report, 0);
  if (layout.key_codes) pad_.keys = pressed_keys(*layout.key_codes, report);
  if (layout.changed_key) {
    const auto which = read_bits(layout.changed_key, report, 0);
    const std::uint64_t key = which == 0 ? 0 : std::bit_floor(which);
    const bool down = layout.changed_key_down && layout.changed_key_down->holds(report);
    pad_.keys = down ? pad_.keys | key : pad_.keys & ~key;
  }
  if (layout.ring) pad_.wheel_position = static_cast<std::int32_t>(layout.ring->read_or(report, -1));
  if (layout.second_ring)
    pad_.second_wheel_position = static_cast<std::int32_t>(layout.second_ring->read_or(report, -1));
  pad_.strip = read(layout.strip, report, pad_.strip);
  pad_.second_strip = read(layout.second_strip, report, pad_.second_strip);
  pad_.wheel_delta = layout.dial ? static_cast<std::int32_t>(layout.dial->read(report)) : 0;
  pad_.second_wheel_delta = layout.second_dial ? static_cast<std::int32_t>(layout.second_dial->read(report)) : 0;
  if (layout.wheel_buttons) pad_.wheel_buttons = read_bits(layout.wheel_buttons, report, 0);
}

bool LayoutDecoder::apply_touch_pad(base::Bytes report) {
  constexpr std::size_t k_entry = 8;
  constexpr std::uint8_t k_contact_mask = 0x81;
  constexpr std::uint8_t k_pad_keys_bit = 0x80;
  if (report[2] == k_contact_mask) return false;
  bool has_keys = false;
  const std::size_t count = report[1];
  for (std::size_t i = 0, at = 2; i < count && at + k_entry <= report.size(); ++i, at += k_entry) {
    if (report[at] != k_pad_keys_bit) continue;
    pad_.keys = report[at + 1] & 0x0fU;
    has_keys = true;
  }
  return has_keys;
}

}  // namespace penpose::decode
