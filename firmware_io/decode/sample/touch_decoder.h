#pragma once

#include <memory>

#include "core/base/byte_reader.h"
#include "firmware_io/decode/sample/pen_sample.h"
#include "firmware_io/decode/sample/touch_slots.h"

namespace penpose::decode {

/// The switch that turns touch off, which a tablet may have among its keys, on another interface than its fingers. One
/// for all interfaces of a tablet.
struct TouchSwitch {
  bool present = false;    ///< the tablet has such a switch
  bool on = false;         ///< as it was last said
  bool has_touch = false;  ///< there is an interface to be switched
  unsigned told = 0;       ///< how often its state was told of

  [[nodiscard]] bool mutes() const { return present && !on; }
};

struct TouchAxes {
  Axis x, y;
  unsigned contacts = 0;   ///< the most at a time
  bool on_screen = false;  ///< the fingers touch the picture itself
};

/// Turns the raw reports of one interface into the fingers on the tablet. Works beside the interface's PenDecoder and
/// gets the same reports, every one, in order. It never allocates in `decode`, never reads outside the report, and
/// takes any bytes whatever.
class TouchDecoder {
 public:
  virtual ~TouchDecoder() = default;
  explicit TouchDecoder(const TouchAxes& axes) : axes_(axes), slots_(axes.contacts) {}
  TouchDecoder(const TouchDecoder&) = delete;
  TouchDecoder& operator=(const TouchDecoder&) = delete;

  /// One raw report, report id first. True when it ended a frame; `contacts()` are the fingers then.
  virtual bool decode(base::Bytes report) = 0;
  /// Forgets all state, as after plugging in.
  virtual void reset() { slots_.clear(); }
  /// Ends a frame early, with what reports have said of it so far: Linux does whenever the state of the switch is told
  /// of, which comes by the fingers' device. True when that showed anything new.
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
