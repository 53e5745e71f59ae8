#include "firmware_io/decode/described/light_report.h"

#include <algorithm>

#include "firmware_io/decode/wacom/hand/wacom_hands.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "firmware_io/decode/wacom/wacom_receiver.h"
#include "firmware_io/hid/event_mark.h"
#include "firmware_io/hid/report_descriptor.h"

namespace penpose::decode {
namespace {

using P = WacomPad;

enum ReportId : std::uint8_t {
  k_receiver_report = 0x03,
  k_lights_report = 0x20,
  k_described_report = 0x32,
  k_bluetooth_report = 0x82
};
constexpr std::size_t k_lights_size = 9;
constexpr std::size_t k_receiver_size = 13;
constexpr std::size_t k_receiver_light_byte = 4;
constexpr std::size_t k_bluetooth_size = 51;
/// Describes the report by which a tablet of 2017 or later takes the light of its ring.
constexpr hid::Usage k_ring_setting = hid::usage(0xff0d, 0x1032);

unsigned light(const Lights& lights, std::size_t side) { return static_cast<unsigned>(lights[side]) & 3U; }

std::vector<std::uint8_t> fixed_report(P pad, const Lights& lights) {
  std::vector<std::uint8_t> report(k_lights_size);
  report[0] = k_lights_report;
  const auto put = [&](std::size_t at, unsigned value) { report[at] = static_cast<std::uint8_t>(value); };
  switch (pad) {
    case P::intuos5:
      // Brightness of the ring, 0 being low, stands above the light; corners of the area above both.
      put(1, light(lights, 0));
      return report;
    case P::intuos4:
    case P::intuos4_bluetooth:
      // Brightness at rest and while a key is held, out of 127, and that of the keys' displays.
      put(1, light(lights, 0) | 4U);
      put(2, 10);
      put(3, 20);
      put(4, 10);
      return report;
    case P::cintiq_21ux2:
    case P::cintiq_24hd:
      put(1, light(lights, 1) | 4U | light(lights, 0) << 4 | 0x40U);
      return report;
    case P::intuos_pro_bluetooth:
      // Lights of power, of the radio and of paper mode, which go on as they are; then brightness out of 100.
      report.assign(k_bluetooth_size, 0);
      put(0, k_bluetooth_report);
      std::fill(report.begin() + 4, report.begin() + 9, std::uint8_t{100});
      put(9, 50);
      put(10, light(lights, 0));
      return report;
    default:
      return {};
  }
}

bool is_receivers_keys(const DeviceIdentity& identity) {
  return is_wacom_receiver(identity) && identity.interface_number == 1;
}

bool is_ring_setting(const hid::Field& field) {
  if (field.type != hid::ReportType::feature || field.report_id != k_described_report) return false;
  for (std::uint32_t i = 0; i < std::min<std::uint64_t>(field.usage_count(), 256); ++i) {
    if (field.usage_of(i) == k_ring_setting) return true;
  }
  return false;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> light_report(const DeviceIdentity& identity, const Lights& lights) {
  if (is_receivers_keys(identity)) {
    // All that have lights and can be behind it are an Intuos5 or one of its kind.
    std::vector<std::uint8_t> report(k_receiver_size);
    report[0] = k_receiver_report;
    report[k_receiver_light_byte] = static_cast<std::uint8_t>(light(lights, 0));
    return report;
  }
  if (identity.vendor != k_vendor_wacom || identity.report_descriptor.empty()) return std::nullopt;
  if (hid::has_event_mark(identity.report_descriptor)) return std::nullopt;
  const auto descriptor = hid::parse_report_descriptor(identity.report_descriptor, hid::Strictness::tolerant);
  if (!descriptor) return std::nullopt;
  // A tablet that does not say that it takes the report is not sent it.
  const auto declares = [&](const std::vector<std::uint8_t>& report) {
    return !report.empty() && descriptor->report_length(hid::ReportType::feature, report[0]) == report.size();
  };
  if (const WacomHand* hand = find_wacom_hand(identity.bus, identity.vendor, identity.product)) {
    auto report = fixed_report(hand->pad, lights);
    return declares(report) ? std::optional(std::move(report)) : std::nullopt;
  }
  if (std::none_of(descriptor->fields.begin(), descriptor->fields.end(), is_ring_setting)) return std::nullopt;
  const std::size_t size = descriptor->report_length(hid::ReportType::feature, k_described_report);
  constexpr std::size_t k_least = 3;
  if (size < k_least || size > k_lights_size) return std::nullopt;
  std::vector<std::uint8_t> report(size);
  report[0] = k_described_report;
  report[1] = 100;  // brightness in percent
  report[2] = static_cast<std::uint8_t>(light(lights, 0));
  return report;
}

std::optional<std::size_t> only_light_byte(const DeviceIdentity& identity) {
  return is_receivers_keys(identity) ? std::optional(k_receiver_light_byte) : std::nullopt;
}

std::size_t side_of_light_group(const DeviceIdentity& identity, std::size_t group) {
  const WacomHand* hand = find_wacom_hand(identity.bus, identity.vendor, identity.product);
  const bool two = hand != nullptr && (hand->pad == P::cintiq_21ux2 || hand->pad == P::cintiq_24hd);
  return two && group < k_pad_sides ? k_pad_sides - 1 - group : group;
}

}  // namespace penpose::decode
