#include "firmware_io/event/internal/event_layout.h"

#include <algorithm>
#include <array>
#include <linux/input-event-codes.h>
#include <span>
#include <utility>

#include "firmware_io/event/internal/descriptor_writer.h"
#include "firmware_io/hid/event_mark.h"
#include "firmware_io/hid/report_descriptor.h"

namespace penpose::event {
namespace {

using hid::usage;

constexpr std::uint8_t k_pen_report = 1;
constexpr std::uint8_t k_puck_report = 2;
constexpr std::uint8_t k_pad_report = 3;
constexpr std::uint8_t k_touch_report = 4;
/// More have keyboards.
constexpr std::size_t k_most_pad_keys = 100;
/// More hands than two are none of a tablet's business.
constexpr std::int32_t k_most_fingers = 20;
constexpr std::int32_t k_most_slots = 250;

// HID units: centimetre, degree and radian (HID 1.11, 6.2.2.7).
constexpr std::uint32_t k_centimetre = 0x11;
constexpr std::uint32_t k_degree = 0x14;
constexpr std::uint32_t k_radian = 0x12;

// Wacom's vendor page, for what the Digitizer page has no usage for (decode/layout/pen_layout.cpp).
constexpr hid::Usage k_distance = usage(hid::k_page_wacom, 0x132);
constexpr hid::Usage k_finger_wheel = usage(hid::k_page_wacom, 0xd03);
constexpr hid::Usage k_third_barrel_switch = usage(hid::k_page_wacom, 0x5d);
constexpr hid::Usage k_tool_type = usage(hid::k_page_wacom, 0x77);

constexpr hid::Usage k_wheel = usage(hid::k_page_generic_desktop, 0x38);
constexpr hid::Usage k_dial = usage(hid::k_page_generic_desktop, 0x37);
constexpr hid::Usage k_strip = usage(hid::k_page_generic_desktop, 0x33);         // Rx
constexpr hid::Usage k_second_strip = usage(hid::k_page_generic_desktop, 0x34);  // Ry
constexpr hid::Usage k_throttle = usage(0x02, 0xbb);
constexpr hid::Usage k_ac_pan = usage(0x0c, 0x238);

constexpr hid::Usage k_contact_id = usage(hid::k_page_digitizer, 0x51);
constexpr hid::Usage k_contact_count = usage(hid::k_page_digitizer, 0x54);
constexpr hid::Usage k_contact_count_maximum = usage(hid::k_page_digitizer, 0x55);

constexpr auto k_pen_tools =
    std::to_array<std::uint16_t>({BTN_TOOL_PEN, BTN_TOOL_RUBBER, BTN_TOOL_BRUSH, BTN_TOOL_PENCIL, BTN_TOOL_AIRBRUSH});
constexpr auto k_puck_tools = std::to_array<std::uint16_t>({BTN_TOOL_MOUSE, BTN_TOOL_LENS});

ControlUnit length_unit(const AbsRange& range) {
  if (range.resolution <= 0) return {};
  return {k_centimetre, std::int64_t{range.resolution} * 10};
}

bool has_range(const EventAxes& axes, std::uint16_t code) {
  const auto found = axes.abs.find(code);
  return found != axes.abs.end() && !found->second.is_empty();
}

bool has_any(const EventAxes& axes, std::span<const std::uint16_t> keys) {
  return std::any_of(keys.begin(), keys.end(), [&](std::uint16_t key) { return axes.has_key(key); });
}

bool is_between(std::uint16_t code, std::uint16_t first, std::uint16_t last) { return code >= first && code <= last; }

/// The keys that a pad may have. On a pen's node only the numbered ones are a pad's.
std::vector<std::uint16_t> pad_keys(const EventAxes& axes) {
  std::vector<std::uint16_t> keys;
  const bool pen = has_pen(axes);
  for (const std::uint16_t key : axes.keys) {
    const bool numbered = is_between(key, BTN_0, BTN_9) || is_between(key, BTN_BASE, BTN_BASE6) ||
                          is_between(key, BTN_A, BTN_Z) || is_between(key, BTN_TRIGGER_HAPPY1, BTN_TRIGGER_HAPPY40);
    const bool other = is_between(key, BTN_MISC, KEY_MAX) && !is_between(key, BTN_DIGI, BTN_TOOL_QUADTAP);
    const bool program = key == KEY_PROG1 || key == KEY_PROG2 || key == KEY_PROG3;
    if (numbered || (!pen && (other || program))) keys.push_back(key);
  }
  return keys;
}

/// Linux gives whole units per radian; where a whole number per degree is behind it, that is meant.
ControlUnit angle_unit(const AbsRange& range) {
  if (range.resolution <= 0) return {};
  constexpr double k_degrees = 57.29577951308232;  // in a radian
  const auto per_degree = static_cast<std::int64_t>(range.resolution / k_degrees + 0.5);
  const double off = static_cast<double>(per_degree) * k_degrees - range.resolution;
  if (per_degree > 0 && off >= -1 && off <= 1) return {k_degree, per_degree};
  return {k_radian, range.resolution};
}

class Maker {
 public:
  explicit Maker(const EventAxes& axes) : axes_(axes) {}

  EventLayout make() {
    for (const std::uint16_t tool : k_pen_tools) {
      if (axes_.has_key(tool)) layout_.pen_tools.push_back(tool);
    }
    for (const std::uint16_t tool : k_puck_tools) {
      if (axes_.has_key(tool)) layout_.puck_tools.push_back(tool);
    }
    if (has_pen(axes_)) {
      // Without a puck's key it is a pen, whatever says that it is near.
      if (!layout_.pen_tools.empty() || layout_.puck_tools.empty()) add_pen();
      if (!layout_.puck_tools.empty()) add_puck();
    }
    if (has_pad(axes_)) add_pad();
    if (has_fingers(axes_)) add_fingers();
    writer_.append(hid::k_event_mark);
    layout_.descriptor = writer_.take();
    return std::move(layout_);
  }

 private:
  PlacedControl place(const Control& control, From from, std::uint16_t type, std::uint16_t code) {
    PlacedControl placed;
    placed.from = from;
    placed.type = type;
    placed.code = code;
    placed.bit_size = control.bit_size;
    placed.bit_offset = writer_.input(control);
    const bool is_signed = control.minimum < 0;
    const std::int64_t half = std::int64_t{1} << (control.bit_size - 1);
    placed.minimum = is_signed ? -half : 0;
    placed.maximum = is_signed ? half - 1 : 2 * half - 1;
    return placed;
  }

  void add_flag(PlacedReport& report, hid::Usage meaning, From from, std::uint16_t key = 0) {
    report.controls.push_back(place({meaning}, from, EV_KEY, key));
  }

  static Control axis_control(hid::Usage meaning, const AbsRange& range, const ControlUnit& unit) {
    Control control;
    control.usage = meaning;
    control.minimum = range.minimum;
    control.maximum = range.maximum;
    control.unit = unit;
    // A driver may leave the range by a little, which decoders see and Linux's HID drivers do as well.
    const bool is_signed = range.minimum < 0;
    const bool fits = is_signed ? range.minimum >= -0x8000 && range.maximum <= 0x7fff : range.maximum <= 0xffff;
    control.bit_size = fits ? 16 : 32;
    return control;
  }

  void add_axis(PlacedReport& report, std::uint16_t code, hid::Usage meaning, ControlUnit (*unit)(const AbsRange&)) {
    const auto found = axes_.abs.find(code);
    if (found == axes_.abs.end() || found->second.is_empty()) return;
    const Control control = axis_control(meaning, found->second, unit != nullptr ? unit(found->second) : ControlUnit{});
    report.controls.push_back(place(control, From::state, EV_ABS, code));
  }

  void add_number(PlacedReport& report, std::uint16_t type, std::uint16_t code, hid::Usage meaning) {
    Control control;
    control.usage = meaning;
    control.bit_size = 32;
    control.maximum = 0xffffffff;
    report.controls.push_back(place(control, From::number, type, code));
  }

  /// What pens and pucks have alike.
  void add_places(PlacedReport& report) {
    add_axis(report, ABS_X, hid::k_x, length_unit);
    add_axis(report, ABS_Y, hid::k_y, length_unit);
    add_axis(report, ABS_DISTANCE, k_distance, length_unit);
    if (const auto z = axes_.abs.find(ABS_Z); z != axes_.abs.end()) {
      // Wacom's driver puts the turn of a pen there, either way from its middle; HID's own Z is a height.
      const bool turn = z->second.minimum < 0;
      add_axis(report, ABS_Z, turn ? hid::k_twist : hid::k_z, turn ? angle_unit : length_unit);
    }
    add_axis(report, ABS_WHEEL, k_finger_wheel, nullptr);
    if (axes_.mscs.contains(MSC_SERIAL)) add_number(report, EV_MSC, MSC_SERIAL, hid::k_transducer_serial);
    // Wacom's driver puts the kind of the tool there and gives it no range; HID drivers put there what they do not
    // know.
    const auto misc = axes_.abs.find(ABS_MISC);
    if (misc != axes_.abs.end() && misc->second.is_empty()) add_number(report, EV_ABS, ABS_MISC, k_tool_type);
  }

  void begin(PlacedReport& report, std::uint8_t id, hid::Usage application, hid::Usage physical) {
    report.id = id;
    writer_.open(hid::k_collection_application, application);
    writer_.open(hid::k_collection_physical, physical);
    writer_.begin_report(id);
  }
  void end(PlacedReport& report) {
    report.length = writer_.report_length();
    writer_.close();
    writer_.close();
  }

  void add_pen() {
    PlacedReport& pen = layout_.pen;
    begin(pen, k_pen_report, hid::k_pen, hid::k_stylus);
    const bool erases = axes_.has_key(BTN_TOOL_RUBBER);
    if (axes_.has_key(BTN_TOUCH)) add_flag(pen, hid::k_tip_switch, From::pen_touch);
    if (axes_.has_key(BTN_STYLUS)) add_flag(pen, hid::k_barrel_switch, From::state, BTN_STYLUS);
    if (axes_.has_key(BTN_STYLUS2)) add_flag(pen, hid::k_secondary_barrel_switch, From::state, BTN_STYLUS2);
    if (axes_.has_key(BTN_STYLUS3)) add_flag(pen, k_third_barrel_switch, From::state, BTN_STYLUS3);
    if (erases) add_flag(pen, hid::k_invert, From::eraser);
    if (erases) add_flag(pen, hid::k_eraser, From::erase);
    if (!layout_.pen_tools.empty()) add_flag(pen, hid::k_in_range, From::near);
    writer_.pad();
    add_places(pen);
    add_axis(pen, ABS_PRESSURE, hid::k_tip_pressure, nullptr);
    add_axis(pen, ABS_TILT_X, hid::k_x_tilt, angle_unit);
    add_axis(pen, ABS_TILT_Y, hid::k_y_tilt, angle_unit);
    end(pen);
  }

  void add_puck() {
    PlacedReport& puck = layout_.puck;
    begin(puck, k_puck_report, hid::k_digitizer, hid::k_puck);
    if (axes_.has_key(BTN_LEFT)) add_flag(puck, hid::k_barrel_switch, From::state, BTN_LEFT);
    if (axes_.has_key(BTN_RIGHT)) add_flag(puck, hid::k_secondary_barrel_switch, From::state, BTN_RIGHT);
    if (axes_.has_key(BTN_MIDDLE)) add_flag(puck, k_third_barrel_switch, From::state, BTN_MIDDLE);
    add_flag(puck, hid::k_in_range, From::near);
    writer_.pad();
    add_places(puck);
    end(puck);
  }

  void add_turns(std::uint16_t code, hid::Usage meaning) {
    if (!axes_.rels.contains(code)) return;
    Control control;
    control.usage = meaning;
    control.bit_size = 16;
    control.minimum = -0x7fff;
    control.maximum = 0x7fff;
    control.flags |= hid::k_flag_relative;
    layout_.pad.controls.push_back(place(control, From::state, EV_REL, code));
  }

  /// As Linux's hid-uclogic describes those of other makers.
  void add_pad() {
    PlacedReport& pad = layout_.pad;
    begin(pad, k_pad_report, hid::k_keypad, hid::k_tablet_function_keys);
    for (const std::uint16_t key : pad_keys(axes_)) {
      const auto number = static_cast<std::uint16_t>(key - BTN_MISC + 1);
      add_flag(pad, key >= BTN_MISC ? usage(hid::k_page_button, number) : usage(hid::k_page_event, key), From::state,
               key);
    }
    writer_.pad();
    if (!has_pen(axes_)) {
      add_axis(pad, ABS_WHEEL, k_wheel, nullptr);
      add_axis(pad, ABS_THROTTLE, k_throttle, nullptr);
      add_axis(pad, ABS_RX, k_strip, nullptr);
      add_axis(pad, ABS_RY, k_second_strip, nullptr);
      add_turns(REL_WHEEL, k_wheel);
      add_turns(REL_HWHEEL, k_ac_pan);
      add_turns(REL_DIAL, k_dial);
      if (axes_.has_abs(ABS_MISC)) {
        Control finger;
        finger.usage = usage(hid::k_page_event, ABS_MISC);
        finger.bit_size = 8;
        pad.controls.push_back(place(finger, From::on_ring, EV_ABS, ABS_MISC));
      }
    }
    end(pad);
  }

  void add_fingers() {
    const AbsRange slots = axes_.abs.at(ABS_MT_SLOT);
    layout_.slots = static_cast<std::size_t>(std::clamp(slots.maximum, 0, k_most_slots - 1)) + 1;
    const auto count = std::min(static_cast<std::int32_t>(layout_.slots), k_most_fingers);
    layout_.touch.id = k_touch_report;
    const bool on_screen = axes_.properties.contains(INPUT_PROP_DIRECT);
    writer_.open(hid::k_collection_application, on_screen ? hid::k_touch_screen : hid::k_touch_pad);
    writer_.begin_report(k_touch_report);
    const AbsRange x = axes_.abs.at(ABS_MT_POSITION_X);
    const AbsRange y = axes_.abs.at(ABS_MT_POSITION_Y);
    Control number;
    number.bit_size = 8;
    number.maximum = 255;
    for (std::int32_t i = 0; i < count; ++i) {
      writer_.open(hid::k_collection_logical, hid::k_finger);
      PlacedFinger finger;
      finger.tip = place({hid::k_tip_switch}, From::state, EV_ABS, ABS_MT_TRACKING_ID);
      writer_.pad();
      number.usage = k_contact_id;
      finger.id = place(number, From::state, EV_ABS, ABS_MT_SLOT);
      finger.x = place(axis_control(hid::k_x, x, length_unit(x)), From::state, EV_ABS, ABS_MT_POSITION_X);
      finger.y = place(axis_control(hid::k_y, y, length_unit(y)), From::state, EV_ABS, ABS_MT_POSITION_Y);
      writer_.close();
      layout_.fingers.push_back(finger);
    }
    number.usage = k_contact_count;
    layout_.finger_count = place(number, From::state, EV_ABS, ABS_MT_SLOT);
    layout_.touch.length = writer_.report_length();
    number.usage = k_contact_count_maximum;
    number.maximum = count;
    writer_.feature(number);
    writer_.close();
  }

  const EventAxes& axes_;
  DescriptorWriter writer_;
  EventLayout layout_;
};

}  // namespace

bool has_pen(const EventAxes& axes) {
  if (!has_range(axes, ABS_X) || !has_range(axes, ABS_Y)) return false;
  if (has_any(axes, k_pen_tools) || has_any(axes, k_puck_tools)) return true;
  return axes.has_key(BTN_STYLUS) && (axes.has_key(BTN_TOUCH) || has_range(axes, ABS_PRESSURE));
}

bool has_fingers(const EventAxes& axes) {
  return axes.has_abs(ABS_MT_SLOT) && axes.has_abs(ABS_MT_TRACKING_ID) && has_range(axes, ABS_MT_POSITION_X) &&
         has_range(axes, ABS_MT_POSITION_Y) && axes.abs.at(ABS_MT_SLOT).minimum == 0;
}

bool has_pad(const EventAxes& axes) {
  const std::size_t keys = pad_keys(axes).size();
  if (keys > k_most_pad_keys || has_fingers(axes)) return false;
  if (has_pen(axes)) return keys > 0;
  const bool dial = has_range(axes, ABS_WHEEL) || has_range(axes, ABS_RX) || axes.rels.contains(REL_WHEEL) ||
                    axes.rels.contains(REL_HWHEEL) || axes.rels.contains(REL_DIAL);
  const bool two_keys = axes.has_key(BTN_0) && axes.has_key(BTN_1);
  return axes.has_key(BTN_STYLUS) ? keys > 0 || dial : two_keys && dial;
}

std::vector<std::uint8_t> report_descriptor(const EventAxes& axes) { return make_event_layout(axes).descriptor; }

EventLayout make_event_layout(const EventAxes& axes) { return Maker(axes).make(); }

}  // namespace penpose::event
