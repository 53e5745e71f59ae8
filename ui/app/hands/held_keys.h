#pragma once

#include <optional>

#include "ui/app/actions.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/face/kept_features.h"
#include "ui/app/hands/bindings.h"
#include "ui/app/input/pointer_place.h"
#include "ui/app/notices.h"
#include "ui/app/view/hit_map.h"

namespace penpose::app {

/// Keys of tablets and buttons of pens, pressed and held.
class HeldKeys {
 public:
  struct Parts {
    EditingSession& editing;
    Bindings& bindings;
    HandDesk& desk;
    const HitMap& hits;
    Dialogs& dialogs;
    Notices& notices;
    const PointerPlace& place;
    Actions& actions;
    const KeptFeatures& features;
  };
  explicit HeldKeys(const Parts& parts) : parts_(parts) {}

  void press(DeskTablet& tablet, int device, const PadControl& control);
  void let_go(int device, const PadControl& control);
  /// What happens to the view while a key is held; null: nothing.
  [[nodiscard]] const ViewHold* held_view() const;
  /// Says whether the next stroke draws, by where the pointer is and what is held.
  void place_pen();
  /// Takes the tool of a key that is held in hand, and gives the one before it back.
  void follow_tool();
  /// Another document is opened.
  void forget();

 private:
  Parts parts_;
  std::optional<drawing::Tool> tool_before_;  ///< a key holds another one
  std::optional<drawing::ToolKind> tool_held_;
};

}  // namespace penpose::app
