#pragma once

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/hands/bindings.h"
#include "ui/app/panels/panels.h"

namespace penpose::app {

/// What the picture shows and changes.
struct PadOwners {
  const EditingSession& editing;
  const HandDesk& desk;
  Bindings& bindings;
  Dialogs& dialogs;
};

/// A tablet's keys, dials and pen as they lie under the hand, each with what it does; those that are pressed now are
/// lit. A touch chooses one.
void show_pad_picture(PanelContext& context, const PadOwners& with, const DeskTablet& tablet);

/// Which of several models a tablet is taken for, in lines as wide as the dialog; nothing where something tells.
void show_guess(PanelContext& context, const DeskTablet& tablet);

}  // namespace penpose::app
