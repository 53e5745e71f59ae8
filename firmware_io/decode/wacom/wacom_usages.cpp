#include "firmware_io/decode/wacom/wacom_usages.h"

namespace penpose::decode {
namespace {

using hid::usage;
using hid::Usage;

constexpr Usage k_function_keys = usage(hid::k_page_digitizer, 0x39);
constexpr Usage k_wacom_function_keys = usage(hid::k_page_wacom, 0x39);
constexpr Usage k_wacom_digitizer_info = usage(hid::k_page_wacom, 0x1013);
constexpr Usage k_wacom_digitizer = usage(hid::k_page_wacom, 0x01);
constexpr Usage k_wacom_pen = usage(hid::k_page_wacom, 0x02);
constexpr Usage k_g9_pen = usage(0xff09, 0x02);
constexpr Usage k_g9_touch = usage(0xff09, 0x11);
constexpr Usage k_g11_pen = usage(0xff11, 0x02);
constexpr Usage k_g11_touch = usage(0xff11, 0x11);
constexpr Usage k_wacom_touch_pad = usage(k_page_wacom_fingers, 0x05);

}  // namespace

Usage standard_usage(Usage from) {
  const std::uint16_t page = hid::page_of(from);
  const auto sub_page = static_cast<std::uint16_t>((from >> 8) & 0xff);
  const auto id = static_cast<std::uint16_t>(from & 0xff);
  const Usage mirrored = usage(sub_page == 0 ? hid::k_page_digitizer : sub_page, id);
  if (page == k_page_wacom_fingers) return from == k_fingers_valid ? from : mirrored;
  if (page != hid::k_page_wacom) return from;
  switch (from) {
    case k_wacom_sense:
    case k_wacom_serial_high:
    case k_wacom_barrel3:
    case k_wacom_tool_type:
    case k_wacom_distance:
    case k_wacom_report_valid:
    case k_pad_strip:
    case k_pad_strip2:
    case k_pad_ring:
    case k_pad_ring_status:
      return from;
    default:
      break;
  }
  // Pages of keys, digitizers and information are additions, not mirrors.
  return sub_page == 0x04 || sub_page == 0x09 || sub_page == 0x0d || sub_page == 0x10 ? from : mirrored;
}

bool is_wacom_pad(const hid::ReportDescriptor& descriptor, const hid::Field& field) {
  const Usage physical = descriptor.enclosing(field, hid::k_collection_physical);
  return physical == k_function_keys || physical == k_wacom_function_keys || physical == k_wacom_digitizer_info;
}

bool is_wacom_function_keys(const hid::ReportDescriptor& descriptor, const hid::Field& field) {
  const Usage physical = descriptor.enclosing(field, hid::k_collection_physical);
  return physical == k_function_keys || physical == k_wacom_function_keys;
}

bool is_wacom_pen(const hid::ReportDescriptor& descriptor, const hid::Field& field) {
  const Usage application = descriptor.enclosing(field, hid::k_collection_application);
  const Usage physical = descriptor.enclosing(field, hid::k_collection_physical);
  const Usage logical = descriptor.enclosing(field, hid::k_collection_logical);
  return logical == hid::k_stylus || physical == hid::k_stylus || physical == hid::k_pen || application == hid::k_pen ||
         application == hid::k_digitizer || application == k_wacom_pen || application == k_wacom_digitizer ||
         application == k_g9_pen || application == k_g11_pen;
}

bool is_wacom_finger(const hid::ReportDescriptor& descriptor, const hid::Field& field) {
  const Usage application = descriptor.enclosing(field, hid::k_collection_application);
  const Usage physical = descriptor.enclosing(field, hid::k_collection_physical);
  const Usage logical = descriptor.enclosing(field, hid::k_collection_logical);
  return logical == hid::k_finger || physical == hid::k_finger || application == hid::k_touch_screen ||
         application == hid::k_touch_pad || application == k_g9_touch || application == k_g11_touch ||
         application == k_wacom_touch_pad;
}

}  // namespace penpose::decode
