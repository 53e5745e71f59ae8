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

/// Wacom's wireless receiver (ACK-40401), which hears one tablet: a Bamboo of 2011 or later, Intuos5 or Intuos Pro of
/// 2013. Its first interface says which and how charged it is; the second brings what the tablet's pen interface sends
/// on a cable, the third what that of its fingers does. Source: Linux, wacom_wac.c (wacom_wireless_irq) and wacom_sys.c
/// (wacom_wireless_work); the descriptors as `lsusb -v` shows them.
inline constexpr std::uint16_t k_wacom_receiver = 0x0084;

[[nodiscard]] bool is_wacom_receiver(const DeviceIdentity& identity);
/// Whether this is the interface that says which tablet is heard.
[[nodiscard]] bool is_receiver_monitor(const DeviceIdentity& identity);

/// What the receiver says of the tablet behind it.
struct ReceiverStatus {
  std::uint16_t product = 0;  ///< 0: it hears none
  Battery battery;

  friend bool operator==(const ReceiverStatus&, const ReceiverStatus&) = default;
};

/// A report of the first interface, nothing when it is none of the kind.
[[nodiscard]] std::optional<ReceiverStatus> read_receiver_status(base::Bytes report);

/// The charge of the tablet behind a receiver: a pad without keys on the first interface.
class ReceiverMonitor final : public PadDecoder {
 public:
  ReceiverMonitor() : PadDecoder(PadFeatures{}) {}
  bool decode(base::Bytes report) override;
};

/// Which tablet each interface of the receivers among some devices stands for. Gets all their reports; whoever decodes
/// them makes new decoders where it says so.
class WacomReceivers {
 public:
  /// An interface that is another tablet's from now on: that of the tablet that is heard, or the receiver's own again.
  struct Change {
    int device = 0;
    DeviceIdentity identity;
  };

  /// A device came, or came again under its number, receiver or not: the identity by which to decode it.
  [[nodiscard]] DeviceIdentity connect(int device, const DeviceIdentity& identity);
  /// The changes that come with a report; valid until the next call, empty for nearly all.
  std::span<const Change> report(int device, base::Bytes bytes);
  /// The tablet to which a receiver's interface belongs for its user, the first one too; null for other devices.
  [[nodiscard]] const DeviceIdentity* shown(int device) const;
  /// The report that a first interface sent last, for whoever follows its devices anew; empty for all others.
  [[nodiscard]] base::Bytes last_status(int device) const;

 private:
  struct Part {
    DeviceIdentity own;
    bool monitor = false;
    std::vector<std::uint8_t> status;  ///< the last report of it
  };
  /// What stands for the tablet `product` on an interface; the interface itself where there is no such tablet.
  [[nodiscard]] static DeviceIdentity behind(const DeviceIdentity& own, std::uint16_t product);
  [[nodiscard]] std::uint16_t heard_by(const std::string& unit) const;

  std::map<int, Part> parts_;
  std::map<int, DeviceIdentity> shown_;
  std::map<std::string, std::uint16_t> heard_;  ///< products, by the receiver's unit
  std::vector<Change> changes_;
};

}  // namespace penpose::decode
