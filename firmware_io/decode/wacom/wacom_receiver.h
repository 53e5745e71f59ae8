#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pad_decoder.h"

namespace penpose::decode {

/// Wacom's wireless receiver (ACK-40401), which connects one tablet: a Bamboo of 2011 or later, Intuos5 or Intuos Pro
/// of 2013. Its first interface reports the tablet and its charge; the second has the reports of the tablet's pen
/// interface, the third those of its touch interface, as over a cable. Source: Linux, wacom_wac.c (wacom_wireless_irq)
/// and wacom_sys.c (wacom_wireless_work); the descriptors are from `lsusb -v`.
inline constexpr std::uint16_t k_wacom_receiver = 0x0084;

[[nodiscard]] bool is_wacom_receiver(const DeviceIdentity& identity);
/// Whether this is the interface that reports the connected tablet.
[[nodiscard]] bool is_receiver_monitor(const DeviceIdentity& identity);

/// The receiver's report about its tablet.
struct ReceiverStatus {
  std::uint16_t product = 0;  ///< 0: no tablet
  Battery battery;

  friend bool operator==(const ReceiverStatus&, const ReceiverStatus&) = default;
};

/// Parses a report of the first interface; nothing if it is of another kind.
[[nodiscard]] std::optional<ReceiverStatus> read_receiver_status(base::Bytes report);

/// The charge of the tablet behind a receiver: a pad without keys on the first interface.
class ReceiverMonitor final : public PadDecoder {
 public:
  ReceiverMonitor() : PadDecoder(PadFeatures{}) {}
  bool decode(base::Bytes report) override;
};

/// Tracks which tablet each interface of some receivers represents. It gets all their reports; the caller makes new
/// decoders for each Change.
class WacomReceivers {
 public:
  /// An interface that represents another tablet from now on: the connected one, or the receiver itself again.
  struct Change {
    int device = 0;
    DeviceIdentity identity;
  };

  /// A device was connected, or again under its number, receiver or not. Returns the identity by which to decode it.
  [[nodiscard]] DeviceIdentity connect(int device, const DeviceIdentity& identity);
  /// The changes from a report; valid until the next call, empty for nearly all.
  std::span<const Change> report(int device, base::Bytes bytes);
  /// The tablet of a receiver's interface, including the first one; null for other devices.
  [[nodiscard]] const DeviceIdentity* shown(int device) const;
  /// The last report of a first interface, for a caller that starts again; empty for all others.
  [[nodiscard]] base::Bytes last_status(int device) const;

 private:
  struct Part {
    DeviceIdentity own;
    bool monitor = false;
    std::vector<std::uint8_t> status;  ///< its last report
  };
  /// The identity of the tablet `product` on an interface; the interface's own if there is no such tablet.
  [[nodiscard]] static DeviceIdentity behind(const DeviceIdentity& own, std::uint16_t product);
  [[nodiscard]] std::uint16_t heard_by(const std::string& unit) const;

  std::map<int, Part> parts_;
  std::map<int, DeviceIdentity> shown_;
  std::map<std::string, std::uint16_t> heard_;  ///< products, by the receiver's unit
  std::vector<Change> changes_;
};

}  // namespace penpose::decode
