#include "firmware_io/decode/wacom/wacom_receiver.h"

#include <algorithm>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/sample/report_bytes.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "firmware_io/hid/event_mark.h"

namespace penpose::decode {
namespace {

constexpr std::size_t k_status_size = 32;
constexpr std::uint8_t k_status_report = 0x80;

}  // namespace

bool is_wacom_receiver(const DeviceIdentity& identity) {
  return identity.bus == k_bus_usb && identity.vendor == k_vendor_wacom && identity.product == k_wacom_receiver &&
         !hid::has_event_mark(identity.report_descriptor);
}

bool is_receiver_monitor(const DeviceIdentity& identity) {
  if (!is_wacom_receiver(identity)) return false;
  // A recording may leave out the number; the other two have no reports of this length.
  if (!identity.interface_number) return identity.input_report_length == k_status_size;
  return *identity.interface_number == 0;
}

std::optional<ReceiverStatus> read_receiver_status(base::Bytes report) {
  if (report.size() != k_status_size || report[0] != k_status_report) return std::nullopt;
  ReceiverStatus status;
  if (!bit(report, 1, 0x01)) return status;
  status.product = static_cast<std::uint16_t>(be16(report, 6));
  const int percent = std::min((report[5] & 0x3f) * 100 / 31, 100);
  status.battery = {static_cast<std::int8_t>(percent), bit(report, 5, 0x80)};
  return status;
}

bool ReceiverMonitor::decode(base::Bytes report) {
  if (const auto status = read_receiver_status(report)) battery_ = status->battery;
  return false;
}

DeviceIdentity WacomReceivers::behind(const DeviceIdentity& own, std::uint16_t product) {
  // 0 is a tablet of its own by cable.
  const WacomModel* model = product != 0 ? find_wacom_model(k_bus_usb, k_vendor_wacom, product) : nullptr;
  if (model == nullptr) return own;
  DeviceIdentity tablet = own;
  tablet.product = product;
  tablet.name = "Wacom " + std::string(model->name) + " (wireless)";
  return tablet;
}

std::uint16_t WacomReceivers::heard_by(const std::string& unit) const {
  const auto found = heard_.find(unit);
  return found == heard_.end() ? 0 : found->second;
}

DeviceIdentity WacomReceivers::connect(int device, const DeviceIdentity& identity) {
  parts_.erase(device);
  shown_.erase(device);
  if (!is_wacom_receiver(identity)) return identity;
  DeviceIdentity own = identity;
  complete_identity(own);
  const bool monitor = is_receiver_monitor(own);
  // Plugged in anew it has heard nothing yet.
  if (monitor) heard_.erase(own.unit);
  shown_[device] = behind(own, heard_by(own.unit));
  parts_[device] = {std::move(own), monitor, {}};
  return monitor ? identity : shown_[device];
}

std::span<const WacomReceivers::Change> WacomReceivers::report(int device, base::Bytes bytes) {
  changes_.clear();
  const auto found = parts_.find(device);
  if (found == parts_.end() || !found->second.monitor) return changes_;
  const auto status = read_receiver_status(bytes);
  if (!status) return changes_;
  found->second.status.assign(bytes.begin(), bytes.end());
  const std::string& unit = found->second.own.unit;
  if (status->product == heard_by(unit)) return changes_;
  heard_[unit] = status->product;
  for (const auto& [number, part] : parts_) {
    if (part.own.unit != unit) continue;
    shown_[number] = behind(part.own, status->product);
    changes_.push_back({number, part.monitor ? part.own : shown_[number]});
  }
  return changes_;
}

const DeviceIdentity* WacomReceivers::shown(int device) const {
  const auto found = shown_.find(device);
  return found == shown_.end() ? nullptr : &found->second;
}

base::Bytes WacomReceivers::last_status(int device) const {
  const auto found = parts_.find(device);
  return found == parts_.end() ? base::Bytes() : base::Bytes(found->second.status);
}

}  // namespace penpose::decode
