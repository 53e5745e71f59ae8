#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "firmware_io/decode/described/described_control.h"
#include "firmware_io/decode/sample/pad_decoder.h"

namespace penpose::decode {

/// The control with the charge of a battery, which many devices describe over Bluetooth.
struct BatteryLayout {
  bool has_report_ids = false;
  std::uint8_t report_id = 0;
  std::uint32_t report_length = 0;
  DescribedControl charge;
};

/// The charge that an interface describes: Battery Strength of the Generic Device Controls, or the state of charge of
/// the Battery System. Nothing if there is none, or if it is a pen's.
[[nodiscard]] std::optional<BatteryLayout> find_battery(const hid::ReportDescriptor& descriptor);

/// The charge that a report gives, in percent; nothing if it is another one or gives none.
[[nodiscard]] std::optional<std::int8_t> charge_in(const BatteryLayout& layout, base::Bytes report);

/// A pad without keys, which reports only its battery.
class BatteryDecoder final : public PadDecoder {
 public:
  explicit BatteryDecoder(const BatteryLayout& layout) : PadDecoder(PadFeatures{}), layout_(layout) {}
  bool decode(base::Bytes report) override;

 private:
  BatteryLayout layout_;
};

}  // namespace penpose::decode
