#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "ui/app/actions.h"
#include "ui/app/controls/controls.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/hands/hand_desk.h"
#include "ui/app/input/pointer_place.h"
#include "ui/app/playback/playback.h"
#include "ui/app/view/hit_map.h"

namespace penpose::app {

/// Rings, strips and wheels of tablets, and what turns on a pen: what they change while they are turned.
class Dials {
 public:
  struct Parts {
    std::function<std::int64_t()> clock;
    EditingSession& editing;
    Canvas& canvas;
    const HitMap& hits;
    Dialogs& dialogs;
    Playback& playback;
    Controls& controls;
    Notices& notices;
    HandDesk& desk;
    const PointerPlace& place;
    Actions& actions;
  };
  explicit Dials(Parts parts) : parts_(std::move(parts)) {}

  /// Turns one by some 120ths of a notch.
  void turn(DialUse use, int device, const PadControl& control, std::int32_t steps);
  /// The finger has left the ring or the strip.
  void let_go();
  /// What was turned stays as it is, and is done.
  void end();
  /// The same once a wheel has rested for long enough.
  void follow();
  /// Whether a wheel turns, of which only rest says that it is done.
  [[nodiscard]] bool waits() const { return use_ && !touched_; }
  /// Another document is opened.
  void forget();

 private:
  void turn_control(double notches);

  Parts parts_;
  std::optional<DialUse> use_;  ///< one is being turned
  bool touched_ = false;        ///< by a finger that will let go
  std::int64_t turned_us_ = 0;  ///< when it last was
  std::string control_;         ///< the control that it changes
  double value_ = 0;
};

}  // namespace penpose::app
