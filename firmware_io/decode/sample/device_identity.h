#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace penpose::decode {

inline constexpr std::uint16_t k_bus_usb = 3;
inline constexpr std::uint16_t k_bus_bluetooth = 5;
inline constexpr std::uint16_t k_bus_virtual = 6;

/// The known properties of one interface of a device before its first report. A trace has bus, ids, name and report
/// descriptor; live hardware may have the others too. Absent means unknown, never "none": an unknown value contradicts
/// no condition.
struct DeviceIdentity {
  std::uint16_t bus = k_bus_usb;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::optional<int> interface_number;  ///< USB interface number
  std::string name;
  /// The same for all interfaces of one tablet and different for others: where it is plugged in. Empty: unknown.
  std::string unit;

  /// Bytes of the longest report of each kind, the report id byte included (0: the interface has no such report).
  std::optional<std::uint16_t> input_report_length;
  std::optional<std::uint16_t> output_report_length;
  std::optional<std::uint16_t> feature_report_length;

  /// USB string descriptors that were read, by index; an index without entry was not read.
  std::map<int, std::string> strings;

  std::vector<std::uint8_t> report_descriptor;  ///< raw bytes, may be empty
};

/// The unit of a physical path such as "usb-0000:00:14.0-2/input1": the path without its end.
[[nodiscard]] inline std::string unit_of_path(std::string_view physical) {
  const std::size_t end = physical.rfind("/input");
  return std::string(physical.substr(0, end));
}

}  // namespace penpose::decode
