#include "firmware_io/decode/wacom/hand/wacom_generic_pad_decoder.h"

#include <algorithm>

#include "firmware_io/decode/wacom/wacom_usages.h"

namespace penpose::decode {
namespace {

using hid::Field;
using hid::ReportDescriptor;
using hid::Usage;

/// How a model counts the places of its ring (Linux, wacom_wac_pad_event).
struct RingSense {
  bool reversed = false;
  std::int32_t shift_16ths = 4;  ///< of a turn
};

RingSense ring_sense(std::uint16_t product) {
  switch (product) {
    case 0x357:  // Intuos Pro 2017
    case 0x358:
    case 0x392:
      return {true, 3};
    case 0x34d:  // MobileStudio Pro
    case 0x34e:
    case 0x398:
    case 0x399:
    case 0x3aa:
      return {true, 8};
    default:
      return {};
  }
}

class PadFinder {
 public:
  PadFinder(const ReportDescriptor& descriptor, std::uint16_t product) : descriptor_(descriptor), product_(product) {}

  std::optional<PadLayout> run();

 private:
  void add_field(const Field& field);
  void add_power(const Field& field);
  /// The control that a usage means; numbers keys and rings as they come.
  std::optional<PadControl> control_of(const Field& field, Usage usage);
  void add(const Field& field, std::uint32_t index, PadControl control);

  const ReportDescriptor& descriptor_;
  std::uint16_t product_;
  PadLayout layout_;
  unsigned keys_ = 0;
  unsigned statuses_ = 0;
  unsigned turns_ = 0;
};

std::optional<PadControl> PadFinder::control_of(const Field& field, Usage usage) {
  PadFeatures& has = layout_.features;
  PadControl control;
  const auto named = [&](PadKey key) {
    control.key = key;
    has.keys.set(key);
    return control;
  };
  if ((usage >= k_pad_first_key && usage <= k_pad_last_key) || (usage >= k_pad_home && usage <= k_pad_center)) {
    if (keys_ >= k_numbered_keys) return std::nullopt;
    control.is_mode_key = usage == k_pad_center;
    if (control.is_mode_key) {
      has.modes = 1;
      has.lights = 4;
      has.mode_keys.set(numbered_key(keys_));
    }
    return named(numbered_key(keys_++));
  }
  switch (usage) {
    case k_pad_button_config:
      return named(PadKey::button_config);
    case k_pad_screen_keyboard:
      return named(PadKey::screen_keyboard);
    case k_pad_control_panel:
      return named(PadKey::control_panel);
    case k_pad_strip:
    case k_pad_strip2:
      control.role = PadRole::strip;
      control.side = usage == k_pad_strip2 ? 1 : 0;
      has.strips = std::max(has.strips, control.side + 1U);
      has.strip_maximum = static_cast<std::int32_t>(field.logical_maximum);
      return control;
    case k_pad_ring: {
      if ((field.flags & hid::k_flag_relative) != 0) {
        if (turns_ >= k_pad_sides) return std::nullopt;
        control.role = PadRole::turn;
        control.side = static_cast<std::uint8_t>(turns_++);
        has.wheels = turns_;
        return control;
      }
      if (has.rings >= k_pad_sides) return std::nullopt;
      const RingSense sense = ring_sense(product_);
      const auto range = static_cast<std::int32_t>(field.logical_maximum - field.logical_minimum + 1);
      control.role = PadRole::ring;
      control.side = static_cast<std::uint8_t>(has.rings++);
      control.reversed = sense.reversed;
      control.shift = static_cast<std::int32_t>(std::int64_t{sense.shift_16ths} * range / 16);
      has.ring_maximum = static_cast<std::int32_t>(field.logical_maximum);
      return control;
    }
    case k_pad_ring_status:
      if (statuses_ >= k_pad_sides) return std::nullopt;
      control.role = PadRole::ring_status;
      control.side = static_cast<std::uint8_t>(statuses_++);
      return control;
    case k_pad_accelerometer_x:
    case k_pad_accelerometer_x + 1:
    case k_pad_accelerometer_x + 2:
      control.role = PadRole::motion;
      return control;
    case k_pad_touch_on:
      control.role = PadRole::touch_on;
      return control;
    case k_pad_mute_touch:
      control.role = PadRole::mute_touch;
      return control;
    default:
      return std::nullopt;
  }
}

void PadFinder::add(const Field& field, std::uint32_t index, PadControl control) {
  control.report_id = field.report_id;
  const bool power = control.role == PadRole::battery || control.role == PadRole::charging;
  control.in_block = is_wacom_function_keys(descriptor_, field) && !power;
  control.is_hand = control.in_block && control.role != PadRole::ring && control.role != PadRole::turn;
  control.place = DescribedControl(field, index);
  layout_.report_length[field.report_id] = descriptor_.report_length(hid::ReportType::input, field.report_id);
  layout_.controls.push_back(control);
}

void PadFinder::add_power(const Field& field) {
  for (std::uint32_t i = 0; i < std::min<std::uint64_t>(field.count, k_most_controls_of_field); ++i) {
    const Usage usage = field.usage_of(i);
    PadControl control;
    if (usage == k_battery_strength || usage == k_pad_battery_level) {
      control.role = PadRole::battery;
    } else if (usage == k_pad_charging) {
      control.role = PadRole::charging;
    } else {
      continue;
    }
    add(field, i, control);
  }
}

void PadFinder::add_field(const Field& field) {
  const std::uint64_t most = std::max<std::uint64_t>(field.usage_count(), field.count);
  for (std::uint32_t i = 0; i < std::min(most, k_most_controls_of_field); ++i) {
    const auto control = control_of(field, field.usage_of(i));
    if (control && i < field.count) add(field, i, *control);
  }
}

std::optional<PadLayout> PadFinder::run() {
  layout_.has_report_ids = descriptor_.has_report_ids;
  for (const Field* field : fields_by_report(descriptor_, hid::ReportType::input)) {
    if (!field->is_variable() || field->bit_size == 0 || field->bit_size > 32) continue;
    add_power(*field);
    const bool mapped = is_wacom_pen(descriptor_, *field) || is_wacom_finger(descriptor_, *field);
    if (mapped && is_wacom_pad(descriptor_, *field)) add_field(*field);
  }
  if (layout_.controls.empty()) return std::nullopt;
  return std::move(layout_);
}

std::int32_t wrapped(std::int64_t value, const DescribedControl& place) {
  const std::int64_t range = place.maximum - place.minimum + 1;
  if (value > place.maximum) value -= range;
  if (value < place.minimum) value += range;
  return static_cast<std::int32_t>(value);
}

}  // namespace

std::optional<PadLayout> find_wacom_pad(const ReportDescriptor& descriptor, std::uint16_t product) {
  return PadFinder(descriptor, product).run();
}

WacomGenericPadDecoder::WacomGenericPadDecoder(PadLayout layout, std::shared_ptr<TouchSwitch> touch)
    : PadDecoder(layout.features), layout_(std::move(layout)), touch_(std::move(touch)) {
  reset_switch();
}

void WacomGenericPadDecoder::reset_switch() {
  const auto has = [this](PadRole role) {
    return std::any_of(layout_.controls.begin(), layout_.controls.end(),
                       [role](const PadControl& control) { return control.role == role; });
  };
  const bool key = has(PadRole::mute_touch);
  if (touch_ == nullptr || (!key && !has(PadRole::touch_on))) return;
  touch_->present = true;
  // A key turns off what was on; of a slide nothing is known before it tells.
  touch_->on = key;
}

void WacomGenericPadDecoder::reset() {
  PadDecoder::reset();
  pending_ = {};
  light_.reset();
  in_use_ = false;
  reset_switch();
}

void WacomGenericPadDecoder::set_light(std::size_t side, std::int8_t light) {
  if (side >= features_.modes) return;
  light_.set(light, features_.lights);
  sample_.mode[side] = pending_.mode[side] = light_.now();
}

bool WacomGenericPadDecoder::decode(base::Bytes report) {
  if (report.empty()) return false;
  const std::uint8_t id = layout_.has_report_ids ? report[0] : 0;
  if (layout_.report_length[id] == 0 || report.size() < layout_.report_length[id]) return false;
  pending_.wheel = {};
  pending_.fine_wheel = {};
  bool hand = false;
  bool in_block = false;
  for (const PadControl& control : layout_.controls) {
    if (control.report_id != id) continue;
    const std::int64_t value = control.place.value(report);
    if (!control.place.holds(value)) continue;
    in_block = in_block || control.in_block;
    hand = hand || (control.is_hand && value != 0);
    apply(control, value);
  }
  if (!in_block || !in_use_) return false;
  in_use_ = hand;
  sample_ = pending_;
  return true;
}

void WacomGenericPadDecoder::apply(const PadControl& control, std::int64_t value) {
  const auto number = static_cast<std::int32_t>(value);
  switch (control.role) {
    case PadRole::key:
      if (control.is_mode_key) pending_.mode[0] = light_.press((value & 1) != 0, features_.lights);
      pending_.keys.set(control.key, value != 0);
      break;
    case PadRole::strip:
      pending_.strip[control.side] = number;
      break;
    case PadRole::ring: {
      const std::int64_t told = control.reversed ? control.place.maximum - value : value;
      pending_.ring[control.side] = wrapped(told + control.shift, control.place);
      if (pending_.ring[control.side] != 0) in_use_ = true;
      return;
    }
    case PadRole::ring_status:
      pending_.ring_touched[control.side] = value != 0;
      if (value == 0) pending_.ring[control.side] = 0;
      return;
    case PadRole::turn:
      pending_.wheel[control.side] = -number;
      pending_.fine_wheel[control.side] = -number * 120;
      break;
    case PadRole::touch_on:
      if (touch_ == nullptr || !touch_->has_touch) return;
      touch_->on = value != 0;
      ++touch_->told;
      return;
    case PadRole::mute_touch:
      if (touch_ == nullptr || !touch_->has_touch) return;
      if (value != 0) touch_->on = !touch_->on;
      ++touch_->told;
      return;
    case PadRole::battery: {
      const std::int64_t range = control.place.maximum - control.place.minimum;
      if (range > 0) battery_.percent = static_cast<std::int8_t>(std::clamp<std::int64_t>(value * 100 / range, 0, 100));
      return;
    }
    case PadRole::charging:
      battery_.charging = value != 0;
      return;
    case PadRole::motion:
      break;
  }
  if (value != 0) in_use_ = true;
}

}  // namespace penpose::decode
