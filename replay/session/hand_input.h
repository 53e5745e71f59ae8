#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "firmware_io/decode/described/light_report.h"
#include "firmware_io/decode/hand/palm_guard.h"
#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/decode/sample/pad_events.h"
#include "replay/session/touch_switches.h"

namespace penpose::replay {

/// Something that the hand which holds no pen did.
struct HandMoment {
  enum class Kind : std::uint8_t {
    pad,      ///< `event`
    fingers,  ///< a frame of fingers ended: they are in HandInput::fingers
    battery,  ///< the charge is another one
    tablet,   ///< a receiver hears another tablet: what the device stands for has changed
  };
  Kind kind = Kind::pad;
  int device = 0;
  decode::PadEvent event;
};

/// Raw reports of any number of interfaces to what keys, dials and fingers say. Beside PenInput, with the same reports.
/// Fingers are held back on every tablet while a pen is near on any.
class HandInput {
 public:
  /// `own` (may be null) are the user's tablets; it must outlive this.
  explicit HandInput(const decode::TabletTable* own = nullptr) : own_(own), switches_(own) {}

  /// An interface came, or came again under its number.
  void connect(int device, const decode::DeviceIdentity& identity);
  /// It went: what was held on it is let go. Valid until the next call.
  std::span<const HandMoment> disconnect(int device, std::int64_t time_us);
  /// A pen came near or left, on whatever tablet.
  void pen(int device, bool near, std::int64_t time_us);
  /// One report. What is returned is valid until the next call.
  std::span<const HandMoment> report(int device, std::int64_t time_us, base::Bytes bytes);

  /// Which lights are on beside the dials of a device, also of one that is connected before its next report: a replay
  /// learns of a device with its first report only.
  void set_lights(int device, const decode::Lights& lights);

  /// The state of a device's pad, null where it has none.
  [[nodiscard]] const decode::PadDecoder* pad(int device) const;
  [[nodiscard]] const decode::TouchDecoder* touch(int device) const;
  /// The fingers on a device that are no palm, as of the last frame.
  [[nodiscard]] std::span<const decode::TouchContact> fingers(int device) const;

 private:
  struct Interface {
    decode::HandDecoders hand;
    decode::PadEvents events;
    decode::PalmGuard palm;
    decode::Battery battery;
    std::vector<decode::TouchContact> fingers;
  };

  void apply_lights(int device, const decode::Lights& lights);
  void take_events(int device);
  void end_frame(int device, Interface& interface, std::int64_t time_us);

  const decode::TabletTable* own_;
  std::map<int, Interface> interfaces_;
  TouchSwitches switches_;
  std::map<int, decode::Lights> lights_;  ///< seen since the last report, by device
  std::map<int, bool> pens_;              ///< whether one is near, by device
  std::set<int> virtual_;                 ///< devices that stand for a mouse, which holds no fingers back
  std::vector<decode::PadEvent> events_;
  std::vector<HandMoment> moments_;
};

}  // namespace penpose::replay
