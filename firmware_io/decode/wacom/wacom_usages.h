#pragma once

#include "firmware_io/hid/report_descriptor.h"

namespace penpose::decode {

// Wacom's vendor usages, named as in the public Linux driver (wacom_wac.h).
inline constexpr std::uint16_t k_page_wacom_fingers = 0xff00;
inline constexpr hid::Usage k_wacom_sense = hid::usage(hid::k_page_wacom, 0x36);
inline constexpr hid::Usage k_wacom_serial_high = hid::usage(hid::k_page_wacom, 0x5c);
inline constexpr hid::Usage k_wacom_barrel3 = hid::usage(hid::k_page_wacom, 0x5d);
inline constexpr hid::Usage k_wacom_tool_type = hid::usage(hid::k_page_wacom, 0x77);
inline constexpr hid::Usage k_wacom_distance = hid::usage(hid::k_page_wacom, 0x132);
inline constexpr hid::Usage k_wacom_report_valid = hid::usage(hid::k_page_wacom, 0x1d0);
inline constexpr hid::Usage k_wacom_finger_wheel = hid::usage(hid::k_page_wacom, 0xd03);
inline constexpr hid::Usage k_fingers_serial = hid::usage(k_page_wacom_fingers, 0x5b);
inline constexpr hid::Usage k_pad_accelerometer_x = hid::usage(hid::k_page_wacom, 0x0401);
inline constexpr hid::Usage k_pad_charging = hid::usage(hid::k_page_wacom, 0x0404);
inline constexpr hid::Usage k_pad_battery_level = hid::usage(hid::k_page_wacom, 0x043b);
inline constexpr hid::Usage k_pad_touch_on = hid::usage(hid::k_page_wacom, 0x0454);
inline constexpr hid::Usage k_pad_strip = hid::usage(hid::k_page_wacom, 0x0136);
inline constexpr hid::Usage k_pad_strip2 = hid::usage(hid::k_page_wacom, 0x0137);
inline constexpr hid::Usage k_pad_ring = hid::usage(hid::k_page_wacom, 0x0138);
inline constexpr hid::Usage k_pad_ring_status = hid::usage(hid::k_page_wacom, 0x0139);
inline constexpr hid::Usage k_pad_first_key = hid::usage(hid::k_page_wacom, 0x0910);
inline constexpr hid::Usage k_pad_last_key = hid::usage(hid::k_page_wacom, 0x091f);
inline constexpr hid::Usage k_pad_mute_touch = hid::usage(hid::k_page_wacom, 0x0981);
inline constexpr hid::Usage k_pad_control_panel = hid::usage(hid::k_page_wacom, 0x0982);
inline constexpr hid::Usage k_pad_screen_keyboard = hid::usage(hid::k_page_wacom, 0x0983);
inline constexpr hid::Usage k_pad_button_config = hid::usage(hid::k_page_wacom, 0x0986);
inline constexpr hid::Usage k_pad_home = hid::usage(hid::k_page_wacom, 0x0990);
inline constexpr hid::Usage k_pad_center = hid::usage(hid::k_page_wacom, 0x0995);  ///< the last of home and directions
inline constexpr hid::Usage k_battery_strength = hid::usage(hid::k_page_digitizer, 0x3b);
inline constexpr hid::Usage k_ring_setting = hid::usage(hid::k_page_wacom, 0x1032);
inline constexpr hid::Usage k_fingers_valid = hid::usage(k_page_wacom_fingers, 0x01d0);

/// The standard usage that a vendor usage mirrors: its second byte is the page, 0 the Digitizer page. Those with a
/// meaning of their own, and the pages of keys and information, stay as they are.
[[nodiscard]] hid::Usage standard_usage(hid::Usage usage);

/// The group of a field by the collections around it. If several match, the pad takes precedence, then the pen.
[[nodiscard]] bool is_wacom_pad(const hid::ReportDescriptor& descriptor, const hid::Field& field);
[[nodiscard]] bool is_wacom_pen(const hid::ReportDescriptor& descriptor, const hid::Field& field);
[[nodiscard]] bool is_wacom_finger(const hid::ReportDescriptor& descriptor, const hid::Field& field);

/// Whether its keys are reported in a function key block, whose state counts as a hand at the pad.
[[nodiscard]] bool is_wacom_function_keys(const hid::ReportDescriptor& descriptor, const hid::Field& field);

}  // namespace penpose::decode
