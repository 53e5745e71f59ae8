#pragma once

#include <cstdint>

namespace penpose::hid {

/// A usage with its page in the upper half, as HID 1.11 section 6.2.2.8 calls an extended usage.
using Usage = std::uint32_t;

[[nodiscard]] constexpr Usage usage(std::uint16_t page, std::uint16_t id) {
  return (static_cast<Usage>(page) << 16) | id;
}
[[nodiscard]] constexpr std::uint16_t page_of(Usage value) { return static_cast<std::uint16_t>(value >> 16); }
[[nodiscard]] constexpr std::uint16_t id_of(Usage value) { return static_cast<std::uint16_t>(value & 0xffff); }

// Pages and usages from "HID Usage Tables 1.5", USB Implementers Forum.
inline constexpr std::uint16_t k_page_generic_desktop = 0x01;
inline constexpr std::uint16_t k_page_button = 0x09;
inline constexpr std::uint16_t k_page_digitizer = 0x0d;
/// Vendor page of Wacom's newer devices: the digitizer usages again, with vendor additions.
inline constexpr std::uint16_t k_page_wacom = 0xff0d;
/// Vendor page of descriptors that stand for a Linux input device (event_mark.h). Usages are the codes of keys where a
/// field has one bit, else of absolute axes (input-event-codes.h).
inline constexpr std::uint16_t k_page_event = 0xff65;
/// Vendor page of Wacom's pens in older descriptors (one opaque block).
inline constexpr std::uint16_t k_page_wacom_opaque = 0xff00;

inline constexpr Usage k_pointer = usage(k_page_generic_desktop, 0x01);
inline constexpr Usage k_mouse = usage(k_page_generic_desktop, 0x02);
inline constexpr Usage k_joystick = usage(k_page_generic_desktop, 0x04);
inline constexpr Usage k_gamepad = usage(k_page_generic_desktop, 0x05);
inline constexpr Usage k_keypad = usage(k_page_generic_desktop, 0x07);
inline constexpr Usage k_x = usage(k_page_generic_desktop, 0x30);
inline constexpr Usage k_y = usage(k_page_generic_desktop, 0x31);
inline constexpr Usage k_z = usage(k_page_generic_desktop, 0x32);

inline constexpr Usage k_digitizer = usage(k_page_digitizer, 0x01);
inline constexpr Usage k_pen = usage(k_page_digitizer, 0x02);
inline constexpr Usage k_touch_screen = usage(k_page_digitizer, 0x04);
inline constexpr Usage k_touch_pad = usage(k_page_digitizer, 0x05);
inline constexpr Usage k_white_board = usage(k_page_digitizer, 0x06);
inline constexpr Usage k_stylus = usage(k_page_digitizer, 0x20);
inline constexpr Usage k_puck = usage(k_page_digitizer, 0x21);
inline constexpr Usage k_finger = usage(k_page_digitizer, 0x22);
inline constexpr Usage k_tip_pressure = usage(k_page_digitizer, 0x30);
inline constexpr Usage k_barrel_pressure = usage(k_page_digitizer, 0x31);
inline constexpr Usage k_in_range = usage(k_page_digitizer, 0x32);
inline constexpr Usage k_quality = usage(k_page_digitizer, 0x36);
inline constexpr Usage k_x_tilt = usage(k_page_digitizer, 0x3d);
inline constexpr Usage k_y_tilt = usage(k_page_digitizer, 0x3e);
inline constexpr Usage k_azimuth = usage(k_page_digitizer, 0x3f);
inline constexpr Usage k_altitude = usage(k_page_digitizer, 0x40);
inline constexpr Usage k_twist = usage(k_page_digitizer, 0x41);
inline constexpr Usage k_tip_switch = usage(k_page_digitizer, 0x42);
inline constexpr Usage k_secondary_tip_switch = usage(k_page_digitizer, 0x43);
inline constexpr Usage k_barrel_switch = usage(k_page_digitizer, 0x44);
inline constexpr Usage k_eraser = usage(k_page_digitizer, 0x45);
inline constexpr Usage k_tablet_function_keys = usage(k_page_digitizer, 0x39);
inline constexpr Usage k_tablet_pick = usage(k_page_digitizer, 0x46);
inline constexpr Usage k_confidence = usage(k_page_digitizer, 0x47);
inline constexpr Usage k_contact_width = usage(k_page_digitizer, 0x48);
inline constexpr Usage k_contact_height = usage(k_page_digitizer, 0x49);
inline constexpr Usage k_contact_id = usage(k_page_digitizer, 0x51);
inline constexpr Usage k_contact_count = usage(k_page_digitizer, 0x54);
inline constexpr Usage k_contact_max = usage(k_page_digitizer, 0x55);
inline constexpr Usage k_scan_time = usage(k_page_digitizer, 0x56);
inline constexpr Usage k_invert = usage(k_page_digitizer, 0x3c);
inline constexpr Usage k_secondary_barrel_switch = usage(k_page_digitizer, 0x5a);
inline constexpr Usage k_transducer_serial = usage(k_page_digitizer, 0x5b);
inline constexpr Usage k_tool_id = usage(k_page_digitizer, 0x77);

}  // namespace penpose::hid
