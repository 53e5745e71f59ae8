#pragma once

#include "ui/app/panels/panels.h"
#include "ui/app/preferences.h"

namespace penpose::app {

/// The menu that "menu" opens, below `top` px.
void show_menu(PanelContext& context, const Preferences& preferences, float top);

}  // namespace penpose::app
