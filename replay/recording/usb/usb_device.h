#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"

namespace penpose::replay {

/// What the descriptors of a USB device say of it (USB 2.0, chapter 9; HID 1.11, chapter 7), as far as its driver has
/// asked for them. Each `take` returns whether something is known now that was not before.
class UsbDevice {
 public:
  /// A device descriptor. One with other ids than before is that of another device in the same place: all else is
  /// forgotten. `is_other`: whether that is so.
  bool take_device(base::Bytes descriptor, bool& is_other);
  /// A configuration with its interfaces and endpoints.
  bool take_configuration(base::Bytes descriptor);
  /// The host chose a configuration by its value.
  void choose_configuration(std::uint8_t value) { chosen_ = value; }
  /// A string descriptor; American English is taken before other languages.
  bool take_string(int index, std::uint16_t language, base::Bytes descriptor);
  /// The report descriptor of a HID interface. `room`: bytes that may be kept beyond those that it replaces.
  bool take_report_descriptor(int interface, base::Bytes descriptor, std::size_t room);

  [[nodiscard]] bool has_ids() const { return has_ids_; }
  [[nodiscard]] std::uint16_t vendor() const { return vendor_; }
  [[nodiscard]] std::uint16_t product() const { return product_; }
  /// Manufacturer and product, as Linux names a HID device; what stands for them where nothing is known.
  [[nodiscard]] std::string name() const;
  /// A string as libusb gives it: characters outside ASCII are '?'.
  [[nodiscard]] std::string string(int index) const;
  /// Strings by index; each is UTF-16, lowest byte first.
  [[nodiscard]] const std::map<int, std::vector<std::uint8_t>>& strings() const { return strings_; }

  [[nodiscard]] bool has_configuration() const { return configuration() != nullptr; }
  /// The interface that an endpoint (0x80 and its number) belongs to; nothing where no descriptor says so.
  [[nodiscard]] std::optional<int> interface_of(std::uint8_t endpoint) const;
  /// Whether an interface is of the class HID, or has a report descriptor.
  [[nodiscard]] bool is_hid(int interface) const;
  /// Numbers of all HID interfaces, in order.
  [[nodiscard]] std::set<int> hid_interfaces() const;
  /// Empty where the driver has not asked for it.
  [[nodiscard]] const std::vector<std::uint8_t>& report_descriptor(int interface) const;
  /// Bytes of report descriptors kept.
  [[nodiscard]] std::size_t kept() const;

 private:
  struct Configuration {
    std::array<std::int16_t, 16> interfaces{};  ///< by endpoint for data from the device, -1: of none
    std::set<int> hid;
  };
  [[nodiscard]] const Configuration* configuration() const;

  bool has_ids_ = false;
  std::uint16_t vendor_ = 0;
  std::uint16_t product_ = 0;
  int manufacturer_string_ = 0;
  int product_string_ = 0;
  std::map<int, std::vector<std::uint8_t>> strings_;
  std::map<int, Configuration> configurations_;  ///< by value
  std::optional<int> chosen_;
  std::map<int, std::vector<std::uint8_t>> report_descriptors_;  ///< by interface
};

}  // namespace penpose::replay
