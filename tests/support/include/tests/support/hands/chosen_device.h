#pragma once

#include <cstdint>
#include <span>

#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/table/tablet_table.h"
#include "firmware_io/decode/wacom/wacom_models.h"

namespace penpose::fuzz {

/// Tablets of the tables by a byte: first Wacom's, of which `rows` are the rows, then some of the others, `stride`
/// apart. False for the last bytes, which are for tablets in no table.
template <typename Row>
bool choose_known(decode::DeviceIdentity& device, std::uint8_t choice, std::span<const Row> rows,
                  const Row* (*find)(std::uint16_t, std::uint16_t, std::uint16_t), std::size_t stride) {
  device.vendor = decode::k_vendor_wacom;
  if (choice < rows.size()) {
    device.product = rows[choice].product;
    const bool cable = find(decode::k_bus_usb, device.vendor, device.product) != nullptr;
    device.bus = cable ? decode::k_bus_usb : decode::k_bus_bluetooth;
    return true;
  }
  if (choice >= 240) return false;
  const auto tablets = decode::known_tablets().tablets();
  const auto& tablet = tablets[(choice - rows.size()) * stride % tablets.size()];
  const auto& identifier = tablet.identifiers.empty() ? tablet.pads.front() : tablet.identifiers.front();
  device = {};
  device.vendor = identifier.vendor;
  device.product = identifier.product;
  device.input_report_length = identifier.input_report_length;
  device.output_report_length = identifier.output_report_length;
  device.feature_report_length = identifier.feature_report_length;
  return true;
}

}  // namespace penpose::fuzz
