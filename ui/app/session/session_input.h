#pragma once

#include <cstdint>
#include <vector>

#include "core/base/byte_reader.h"
#include "firmware_io/decode/sample/device_identity.h"
#include "replay/session/live_session.h"
#include "replay/session/virtual_pen.h"

namespace penpose::app {

class EditingSession;

/// What pens and tablets send to a session.
class SessionInput {
 public:
  explicit SessionInput(EditingSession& editing) : editing_(editing) {}

  /// Moves the pointer that is no tablet.
  std::vector<replay::PenMoment> pen(const replay::VirtualPenState& state);
  void connect(int device, const decode::DeviceIdentity& identity);
  /// Its stroke ends.
  void disconnect(int device);
  std::vector<replay::PenMoment> report(int device, base::Bytes bytes);
  /// The same of a report that came at a moment of the clock.
  std::vector<replay::PenMoment> report_at(int device, std::int64_t received_us, base::Bytes bytes);
  void set_tablet(int device, const replay::TabletSetting& setting);
  /// Says which lights are on beside the dials of a tablet.
  void see_lights(int device, const decode::Lights& lights);
  /// Says whether strokes that begin from now on draw.
  void place_pen(bool on_canvas);

 private:
  EditingSession& editing_;
};

}  // namespace penpose::app
