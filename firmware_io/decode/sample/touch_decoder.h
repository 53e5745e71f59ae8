#pragma once

#include <memory>

#include "core/base/byte_reader.h"
#include "core/base/interface.h"
#include "firmware_io/decode/sample/pen_sample.h"
#include "firmware_io/decode/sample/touch_slots.h"

namespace penpose::decode {

/// The switch that turns touch off. A tablet may have it among its keys, on another interface than its fingers; all
/// interfaces of the tablet share it.
struct TouchSwitch {
  bool present = false;    ///< the tablet has such a switch
  bool on = false;         ///< its last known state
  bool has_touch = false;  ///< there is an interface to switch
  unsigned told = 0;       ///< how often its state was reported

  [[nodiscard]] bool mutes() const { return present && !on; }
};

struct TouchAxes {
  Axis x, y;
  unsigned contacts = 0;   ///< the most at a time
  bool on_screen = false;  ///< the fingers touch the picture itself
};

/// Turns the raw reports of one interface into the fingers on the tablet. Works in parallel with the interface's
/// PenDecoder and gets all the same reports, in order. It never allocates in `decode`, never reads outside the report,
/// and accepts any bytes.
class TouchDecoder : public base::Interface {
 public:
  explicit TouchDecoder(const TouchAxes& axes) : axes_(axes), slots_(axes.contacts) {}

  /// One raw report, report id first. True when it ended a frame; `contacts()` are the fingers then.
  virtual bool decode(base::Bytes report) = 0;
  /// Resets all state, as after plugging in.
  virtual void reset() { slots_.clear(); }
  /// Ends a frame early with the data so far, as Linux does whenever the fingers' device reports the switch. True if
  /// that gave anything new.
  bool end_early() {
    if (!slots_.has_news()) return false;
    slots_.publish();
    return true;
  }

  [[nodiscard]] std::span<const TouchContact> contacts() const { return slots_.contacts(); }
  [[nodiscard]] const TouchAxes& axes() const { return axes_; }

 protected:
  TouchAxes axes_;
  TouchSlots slots_;
};

}  // namespace penpose::decode
