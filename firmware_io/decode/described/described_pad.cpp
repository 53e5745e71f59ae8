#include "firmware_io/decode/described/described_pad.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace penpose::decode {
namespace {

using hid::Field;
using hid::ReportDescriptor;
using hid::Usage;
using Role = DescribedPadRole;

// Codes of events. Source: Linux, include/uapi/linux/input-event-codes.h.
enum class EventType : std::uint8_t { key, relative, absolute };
constexpr std::uint16_t k_button = 0x100;
constexpr std::uint16_t k_mouse_button = 0x110;
constexpr std::uint16_t k_joystick_button = 0x120;
constexpr std::uint16_t k_gamepad_button = 0x130;
constexpr std::uint16_t k_start_button = 0x13b;
constexpr std::uint16_t k_select_button = 0x13a;
constexpr std::uint16_t k_stylus_button = 0x14b;
constexpr std::uint16_t k_stylus_button2 = 0x14c;
constexpr std::uint16_t k_further_button = 0x2c0;
constexpr std::uint16_t k_last_key = 0x2ff;
constexpr std::uint16_t k_relative_misc = 0x09;
constexpr std::uint16_t k_relative_hwheel = 0x06;
constexpr std::uint16_t k_relative_dial = 0x07;
constexpr std::uint16_t k_wheel_fine = 0x0b;
constexpr std::uint16_t k_hwheel_fine = 0x0c;
constexpr std::uint16_t k_absolute_rx = 0x03;
constexpr std::uint16_t k_absolute_ry = 0x04;
constexpr std::uint16_t k_absolute_throttle = 0x06;
constexpr std::uint16_t k_absolute_wheel = 0x08;
constexpr std::uint16_t k_absolute_misc = 0x28;

/// The event that Linux makes of a usage.
struct Event {
  EventType type = EventType::key;
  std::uint16_t code = 0;
  bool shared = false;  ///< several controls may have it
};
using MaybeEvent = std::optional<Event>;

MaybeEvent unknown_event(const Field& field) {
  if (field.bit_size == 1) return Event{EventType::key, k_button};
  if ((field.flags & hid::k_flag_relative) != 0) return Event{EventType::relative, k_relative_misc};
  return Event{EventType::absolute, k_absolute_misc};
}

MaybeEvent button_event(Usage application, Usage physical, std::uint16_t id) {
  const std::uint32_t number = static_cast<std::uint16_t>(id - 1);
  constexpr std::uint32_t k_sixteen = 16;
  std::uint32_t code = number;
  const bool plays = application == hid::k_joystick || application == hid::k_gamepad;
  if (plays && number >= k_sixteen) {
    code += k_further_button - k_sixteen;
  } else {
    const bool named = plays || application == hid::k_mouse || application == hid::k_pointer;
    switch (named ? application : physical) {
      case hid::k_mouse:
      case hid::k_pointer:
        code += k_mouse_button;
        break;
      case hid::k_joystick:
        code += k_joystick_button;
        break;
      case hid::k_gamepad:
        code += k_gamepad_button;
        break;
      default:
        code += k_button;
        break;
    }
  }
  if (code > k_last_key) return std::nullopt;
  return Event{EventType::key, static_cast<std::uint16_t>(code)};
}

MaybeEvent desktop_event(const Field& field, std::uint16_t id) {
  const bool relative = (field.flags & hid::k_flag_relative) != 0;
  const EventType axis = relative ? EventType::relative : EventType::absolute;
  const auto low = static_cast<std::uint16_t>(id & 0x0f);
  switch (id) {
    case 0x30:  // X, Y, Z and the turns about them
    case 0x31:
    case 0x32:
    case 0x33:
    case 0x34:
    case 0x35:
      return Event{axis, low, !relative};
    case 0x36:  // Slider
    case 0x37:  // Dial
      return Event{axis, low};
    case 0x38:  // Wheel
      return relative ? Event{EventType::relative, k_wheel_fine} : Event{EventType::absolute, k_absolute_wheel};
    case 0x3d:
      return Event{EventType::key, k_start_button, true};
    case 0x3e:
      return Event{EventType::key, k_select_button, true};
    default:
      break;
  }
  // Hat switch, system controls, direction pad: nothing that a pad has.
  const bool other = id == 0x39 || (id >= 0x81 && id <= 0x93) || (id >= 0xb0 && id <= 0xbf);
  return other ? std::nullopt : unknown_event(field);
}

MaybeEvent digitizer_event(const Field& field, std::uint16_t id) {
  // What is of pens and fingers, which a pad does not have.
  constexpr std::array<std::uint8_t, 13> k_other{0x00, 0x30, 0x32, 0x33, 0x3b, 0x3c, 0x3d,
                                                 0x3e, 0x42, 0x43, 0x45, 0x5b, 0x6e};
  const auto low = static_cast<std::uint8_t>(id & 0xff);
  if (low == 0x44) return Event{EventType::key, k_stylus_button, true};
  if (low == 0x46 || low == 0x5a) return Event{EventType::key, k_stylus_button2, true};
  if (std::find(k_other.begin(), k_other.end(), low) != k_other.end()) return std::nullopt;
  return unknown_event(field);
}

MaybeEvent simulation_event(std::uint16_t id) {
  constexpr std::array<std::pair<std::uint16_t, std::uint16_t>, 5> k_axes{
      {{0xba, 0x07}, {0xbb, k_absolute_throttle}, {0xc4, 0x09}, {0xc5, 0x0a}, {0xc8, k_absolute_wheel}}};
  for (const auto& [usage, code] : k_axes) {
    if (usage == id) return Event{EventType::absolute, code};
  }
  return std::nullopt;
}

bool is_battery(Usage usage) { return usage == hid::usage(0x06, 0x20) || usage == hid::usage(0x85, 0x65); }

MaybeEvent event_of(const ReportDescriptor& descriptor, const Field& field, Usage usage) {
  const std::uint16_t id = hid::id_of(usage);
  switch (hid::page_of(usage)) {
    case 0x00:    // undefined
    case 0x07:    // keyboard
    case 0x08:    // lights
    case 0x0b:    // telephony
    case 0x0f:    // forces
    case 0x00ff:  // custom
    case 0xff00:  // vendors' that Linux leaves alone
    case 0xff01:
    case 0xff09:
    case 0xff43:
    case 0xff7f:
    case 0xffbc:
      return std::nullopt;
    case hid::k_page_generic_desktop:
      return desktop_event(field, id);
    case 0x02:
      return simulation_event(id);
    case hid::k_page_button:
      return button_event(descriptor.enclosing(field, hid::k_collection_application),
                          descriptor.enclosing(field, hid::k_collection_physical), id);
    case 0x0c:  // of the consumer page only AC Pan
      return id == 0x238 ? MaybeEvent(Event{EventType::relative, k_hwheel_fine}) : std::nullopt;
    case hid::k_page_digitizer:
      return digitizer_event(field, id);
    case hid::k_page_event:
      return Event{field.bit_size == 1 ? EventType::key : EventType::absolute, id};
    default:
      return is_battery(usage) ? std::nullopt : unknown_event(field);
  }
}

class PadFinder {
 public:
  explicit PadFinder(const ReportDescriptor& descriptor) : descriptor_(descriptor) {}
  std::optional<DescribedPad> run();

 private:
  [[nodiscard]] bool is_pads(std::uint8_t id) const;
  [[nodiscard]] Usage application_of(std::uint8_t id) const;
  void add_field(const Field& field);
  void add(const Field& field, std::uint32_t index, const Event& event);
  [[nodiscard]] bool set_role(DescribedPadControl& control, const Event& event, const Field& field);
  void place_dials();

  const ReportDescriptor& descriptor_;
  DescribedPad pad_;
  std::map<Usage, std::set<std::pair<EventType, std::uint16_t>>> taken_;  ///< by application
  bool has_buttons_ = false;
};

bool has_usage(const Field& field, Usage usage) {
  return std::any_of(field.usages.begin(), field.usages.end(), [usage](const hid::UsageRange& range) {
    return range.minimum <= usage && usage <= range.maximum;
  });
}

/// Linux makes one device of the reports whose first field is in the same application.
Usage PadFinder::application_of(std::uint8_t id) const {
  for (const Field& field : descriptor_.fields) {
    if (field.type == hid::ReportType::input && field.report_id == id)
      return descriptor_.enclosing(field, hid::k_collection_application);
  }
  return 0;
}

bool PadFinder::is_pads(std::uint8_t id) const {
  bool pads = application_of(id) == hid::k_keypad;
  for (const Field& field : descriptor_.fields) {
    if (field.type != hid::ReportType::input || field.report_id != id) continue;
    if (has_usage(field, hid::k_in_range) || has_usage(field, hid::k_tip_switch)) return false;
    pads = pads || descriptor_.is_inside(field, hid::k_tablet_function_keys);
  }
  return pads;
}

bool PadFinder::set_role(DescribedPadControl& control, const Event& event, const Field& field) {
  PadFeatures& has = pad_.features;
  const auto on_side = [&](Role role, unsigned side, unsigned& count) {
    control.role = role;
    control.side = static_cast<std::uint8_t>(side);
    count = std::max(count, side + 1);
    return true;
  };
  const auto maximum = static_cast<std::int32_t>(std::clamp<std::int64_t>(field.logical_maximum, 0, INT32_MAX));
  if (event.type == EventType::key) {
    const auto key = key_with_code(event.code);
    // What is pressed and let go within a report is never held.
    if (!key || (field.flags & hid::k_flag_relative) != 0) return false;
    control.key = *key;
    // No pad has the buttons of a pen: descriptors have them so that desktops take the device for one of a tablet.
    if (event.code != k_stylus_button && event.code != k_stylus_button2) has.keys.set(*key);
    return true;
  }
  if (event.type == EventType::relative) {
    if (event.code == k_relative_dial) {
      control.role = Role::dial;
      return true;
    }
    if (event.code == k_wheel_fine) return on_side(Role::wheel, 0, has.wheels);
    return (event.code == k_hwheel_fine || event.code == k_relative_hwheel) && on_side(Role::wheel, 1, has.wheels);
  }
  switch (event.code) {
    case k_absolute_wheel:
    case k_absolute_throttle:
      has.ring_maximum = std::max(has.ring_maximum, maximum);
      return on_side(Role::ring, event.code == k_absolute_wheel ? 0 : 1, has.rings);
    case k_absolute_rx:
    case k_absolute_ry:
      has.strip_maximum = std::max(has.strip_maximum, maximum);
      return on_side(Role::strip, event.code == k_absolute_rx ? 0 : 1, has.strips);
    case k_absolute_misc:
      control.role = Role::finger;
      return true;
    default:
      return false;
  }
}

void PadFinder::add(const Field& field, std::uint32_t index, const Event& event) {
  DescribedPadControl control;
  if (!set_role(control, event, field)) return;
  control.report_id = field.report_id;
  control.null_state = (field.flags & hid::k_flag_null_state) != 0;
  control.place = DescribedControl(field, field.is_array() ? 0 : index);
  const std::uint64_t places = field.is_array() ? std::min<std::uint64_t>(field.count, k_most_controls_of_field) : 1;
  if (field.is_array()) {
    if (control.role != Role::key) return;
    control.selectors = static_cast<std::uint32_t>(places);
    control.selected_by = field.logical_minimum + index;
    if (control.selected_by > field.logical_maximum) return;
  }
  std::uint32_t& needed = pad_.needed[field.report_id];
  const std::uint64_t end = control.place.bit_offset + places * field.bit_size;
  needed = std::max(needed, static_cast<std::uint32_t>((end + 7) / 8));
  pad_.controls.push_back(control);
}

void PadFinder::add_field(const Field& field) {
  auto& taken = taken_[application_of(field.report_id)];
  const bool pads = descriptor_.is_inside(field, hid::k_tablet_function_keys);
  const std::uint64_t most = std::max<std::uint64_t>(field.usage_count(), field.count);
  for (std::uint32_t i = 0; i < std::min(most, k_most_controls_of_field); ++i) {
    const Usage usage = field.usage_of(i);
    const auto event = event_of(descriptor_, field, usage);
    if (!event) continue;
    const bool first = taken.emplace(event->type, event->code).second;
    if (!first && !event->shared) continue;
    if (field.is_variable() && i >= field.count) continue;
    const std::size_t before = pad_.controls.size();
    add(field, i, *event);
    if (pad_.controls.size() > before && (pads || hid::page_of(usage) == hid::k_page_button)) has_buttons_ = true;
  }
}

/// A dial is the wheel of a side that has none.
void PadFinder::place_dials() {
  const auto is_taken = [&](std::uint8_t side) {
    return std::any_of(pad_.controls.begin(), pad_.controls.end(), [side](const DescribedPadControl& control) {
      return control.role == Role::wheel && control.side == side;
    });
  };
  for (DescribedPadControl& control : pad_.controls) {
    if (control.role != Role::dial) continue;
    control.side = is_taken(0) ? 1 : 0;
    pad_.features.wheels = std::max(pad_.features.wheels, control.side + 1U);
  }
}

std::optional<DescribedPad> PadFinder::run() {
  pad_.has_report_ids = descriptor_.has_report_ids;
  // Vendors' dials count with the clock, and what describes them leaves their numbers alone.
  pad_.features.wheels_clockwise = true;
  std::map<std::uint8_t, bool> pads;
  for (const Field* field : fields_by_report(descriptor_, hid::ReportType::input)) {
    const std::uint8_t id = field->report_id;
    const auto [known, is_new] = pads.emplace(id, false);
    if (is_new) known->second = is_pads(id);
    if (!known->second) continue;
    pad_.length[id] = descriptor_.report_length(hid::ReportType::input, id);
    if (!field->is_constant() && field->bit_size > 0 && field->bit_size <= 32) add_field(*field);
  }
  if (!has_buttons_) return std::nullopt;
  place_dials();
  return std::move(pad_);
}

}  // namespace

std::optional<std::int64_t> DescribedPadControl::value(base::Bytes report) const {
  DescribedControl at = place;
  for (std::uint32_t i = 0; i < selectors; ++i, at.bit_offset += place.bit_size) {
    if (at.value(report) == selected_by) return 1;
  }
  if (selectors > 0) return 0;
  const std::int64_t value = place.value(report);
  if (place.minimum >= place.maximum || place.holds(value)) return value;
  if (null_state) return std::nullopt;
  return std::clamp(value, place.minimum, place.maximum);
}

bool DescribedPad::has(base::Bytes report) const {
  if (report.empty()) return false;
  const std::uint8_t id = has_report_ids ? report[0] : 0;
  return length[id] != 0 && report.size() >= needed[id];
}

std::optional<DescribedPad> find_described_pad(const ReportDescriptor& descriptor) {
  return PadFinder(descriptor).run();
}

}  // namespace penpose::decode
