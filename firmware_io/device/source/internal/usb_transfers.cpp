#include "firmware_io/device/source/internal/usb_transfers.h"

#include <algorithm>
#include <array>
#include <vector>

#include "firmware_io/decode/table/told_ranges.h"

namespace penpose::device {
namespace {

constexpr unsigned k_timeout_ms = 500;
constexpr std::uint16_t k_american_english = 0x0409;
constexpr std::uint8_t k_to_class_interface = 0x21;  // host to device, class request, recipient interface
constexpr std::uint8_t k_from_interface = 0x81;      // device to host, standard request, recipient interface
constexpr std::size_t k_longest_descriptor = 4096;
constexpr std::uint8_t k_from_class_interface = 0xa1;  // device to host, class request, recipient interface
constexpr std::uint8_t k_get_report = 0x01;
constexpr std::uint8_t k_set_report = 0x09;

}  // namespace

base::Result<std::string> get_string(const UsbHandle& usb, std::uint8_t index) {
  std::array<std::uint8_t, 255> raw{};
  const int got = libusb_control_transfer(usb.get(), LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_DESCRIPTOR,
                                          static_cast<std::uint16_t>((LIBUSB_DT_STRING << 8) | index),
                                          index == 0 ? 0 : k_american_english, raw.data(),
                                          static_cast<std::uint16_t>(raw.size()), k_timeout_ms);
  if (got < 0) return usb_error("string " + std::to_string(index) + " cannot be read", got);
  if (got < 2 || raw[1] != LIBUSB_DT_STRING) {
    return base::Error{"string " + std::to_string(index) + " is none", "", ""};
  }
  const int end = std::min<int>(got, raw[0]);
  if (index == decode::k_ranges_string && end > 2)
    return decode::ranges_text(base::Bytes(raw).subspan(2, static_cast<std::size_t>(end - 2)));
  std::string text;
  for (int i = 2; i + 1 < end; i += 2) {
    const bool ascii = raw[i + 1] == 0 && raw[i] >= 0x20 && raw[i] < 0x7f;
    text += ascii ? static_cast<char>(raw[i]) : '?';
  }
  return text;
}

base::Result<std::vector<std::uint8_t>> get_report_descriptor(const UsbHandle& usb, int interface) {
  std::vector<std::uint8_t> bytes(k_longest_descriptor);
  const int got = libusb_control_transfer(usb.get(), k_from_interface, LIBUSB_REQUEST_GET_DESCRIPTOR,
                                          LIBUSB_DT_REPORT << 8, static_cast<std::uint16_t>(interface), bytes.data(),
                                          static_cast<std::uint16_t>(bytes.size()), k_timeout_ms);
  if (got < 0) return usb_error("the report descriptor cannot be read", got);
  bytes.resize(static_cast<std::size_t>(got));
  return bytes;
}

base::Status set_report(const UsbHandle& usb, int interface, SentReport kind, base::Bytes report) {
  if (report.empty()) return base::Error{"the report is empty", "", ""};
  const std::uint8_t id = report[0];
  std::vector<std::uint8_t> bytes(report.begin() + (id == 0 ? 1 : 0), report.end());
  const int sent = libusb_control_transfer(
      usb.get(), k_to_class_interface, k_set_report, static_cast<std::uint16_t>((static_cast<int>(kind) << 8) | id),
      static_cast<std::uint16_t>(interface), bytes.data(), static_cast<std::uint16_t>(bytes.size()), k_timeout_ms);
  if (sent < 0) return usb_error("the device took no report", sent);
  return base::Done{};
}

base::Result<std::vector<std::uint8_t>> get_feature_report(const UsbHandle& usb, int interface, std::uint8_t id,
                                                           std::size_t length) {
  std::vector<std::uint8_t> bytes(std::min(length, k_longest_descriptor));
  const int got = libusb_control_transfer(usb.get(), k_from_class_interface, k_get_report,
                                          static_cast<std::uint16_t>((static_cast<int>(SentReport::feature) << 8) | id),
                                          static_cast<std::uint16_t>(interface), bytes.data(),
                                          static_cast<std::uint16_t>(bytes.size()), k_timeout_ms);
  if (got < 0) return usb_error("the device gives no report", got);
  bytes.resize(static_cast<std::size_t>(got));
  return bytes;
}

}  // namespace penpose::device
