#include "firmware_io/device/source/libusb/internal/usb_transfers.h"

#include <algorithm>
#include <array>
#include <vector>

#include "firmware_io/device/source/usb_string_text.h"

namespace penpose::device {
namespace {

constexpr unsigned k_timeout_ms = 500;
constexpr std::uint8_t k_to_class_interface = 0x21;  // host to device, class request, recipient interface
constexpr std::uint8_t k_from_interface = 0x81;      // device to host, standard request, recipient interface
constexpr std::size_t k_longest_usb_descriptor = 4096;
constexpr std::uint8_t k_from_class_interface = 0xa1;  // device to host, class request, recipient interface
constexpr std::uint8_t k_get_report = 0x01;
constexpr std::uint8_t k_set_report = 0x09;

}  // namespace

base::Result<std::string> get_string(const UsbHandle& usb, std::uint8_t index) {
  std::array<std::uint8_t, 255> raw{};
  const int got =
      libusb_control_transfer(usb.get(), LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_DESCRIPTOR,
                              static_cast<std::uint16_t>((LIBUSB_DT_STRING << 8) | index), language_of_string(index),
                              raw.data(), static_cast<std::uint16_t>(raw.size()), k_string_timeout_ms);
  if (got < 0) return usb_error("string " + std::to_string(index) + " cannot be read", got);
  return text_of_string(base::Bytes(raw.data(), static_cast<std::size_t>(got)), index);
}

base::Result<std::vector<std::uint8_t>> get_report_descriptor(const UsbHandle& usb, int interface) {
  std::vector<std::uint8_t> bytes(k_longest_usb_descriptor);
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
  std::vector<std::uint8_t> bytes(std::min(length, k_longest_usb_descriptor));
  const int got = libusb_control_transfer(usb.get(), k_from_class_interface, k_get_report,
                                          static_cast<std::uint16_t>((static_cast<int>(SentReport::feature) << 8) | id),
                                          static_cast<std::uint16_t>(interface), bytes.data(),
                                          static_cast<std::uint16_t>(bytes.size()), k_timeout_ms);
  if (got < 0) return usb_error("the device gives no report", got);
  bytes.resize(static_cast<std::size_t>(got));
  return bytes;
}

}  // namespace penpose::device
