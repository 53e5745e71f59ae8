#pragma once

#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/panels.h"

namespace penpose::app {

/// Where a menu of so many rows is, beside what was touched.
[[nodiscard]] Area menu_area(const PanelContext& context, const Canvas& canvas, PxPoint at, double wide, double rows);

}  // namespace penpose::app
