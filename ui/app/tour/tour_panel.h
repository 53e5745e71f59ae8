#pragma once

#include "ui/app/panels/panels.h"
#include "ui/app/tour/tour_guide.h"

namespace penpose::app {

/// Px that a tour's card takes at the foot of the canvas, `width` px wide; 0: no tour is under way.
[[nodiscard]] double tour_height(const PanelContext& context, double width, const TourGuide& guide);
/// Buttons that begin the tours, each in a row of its own.
void show_tour_buttons(PanelContext& context);

}  // namespace penpose::app
