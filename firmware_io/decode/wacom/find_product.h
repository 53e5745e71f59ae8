#pragma once

#include <algorithm>
#include <span>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/wacom/wacom_models.h"

namespace penpose::decode {

/// The row of a product in a table that ascends by `product`; null where it is on another bus than this one. `kind`:
/// the member of a row whose type names the kinds that come through Bluetooth alone. Product ids on other buses (I2C)
/// are numbered independently of these.
template <typename Row, typename Kind>
[[nodiscard]] const Row* find_product(std::span<const Row> rows, Kind Row::*kind, std::uint16_t bus,
                                      std::uint16_t vendor, std::uint16_t product) {
  constexpr std::uint16_t k_lenovo_isdv4 = 0x6004;
  const bool lenovo = vendor == k_vendor_lenovo && product == k_lenovo_isdv4;
  if (vendor != k_vendor_wacom && !lenovo) return nullptr;
  const auto found = std::lower_bound(rows.begin(), rows.end(), product,
                                      [](const Row& row, std::uint16_t id) { return row.product < id; });
  if (found == rows.end() || found->product != product) return nullptr;
  const Kind its = (*found).*kind;
  const bool bluetooth_only = its == Kind::graphire_bluetooth || its == Kind::intuos4_bluetooth ||
                              its == Kind::intuos_pro_bluetooth || its == Kind::intuos_2018_bluetooth;
  if (bus != (bluetooth_only ? k_bus_bluetooth : k_bus_usb) || (product == k_lenovo_isdv4) != lenovo) return nullptr;
  return &*found;
}

}  // namespace penpose::decode
