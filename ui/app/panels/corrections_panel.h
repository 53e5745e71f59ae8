#pragma once

#include "ui/app/panels/panels.h"

namespace penpose::app {

/// The corrections that there are, and what can be done with each.
void show_corrections(PanelContext& context);

}  // namespace penpose::app
