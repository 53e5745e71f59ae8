#pragma once

#include "ui/app/panels/panels.h"

namespace penpose::app {

/// A tablet's keys, dials and pen as they lie under the hand, each with what it does; those that are pressed now are
/// lit. A touch chooses one.
void show_pad_picture(PanelContext& context, const DeskTablet& tablet);

}  // namespace penpose::app
