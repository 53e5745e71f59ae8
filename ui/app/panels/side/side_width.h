#pragma once

#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"

namespace penpose::app {

/// How wide what is in the panel at the right wants to be, px; 0: it says nothing.
struct SideWidth {
  float wanted = 0;
};

/// Px of the panel while it is open: what is in it wants, between what a hand needs and a part of the window.
[[nodiscard]] double side_width(const PanelContext& context, PanelState& panels, double window_width);

}  // namespace penpose::app
