#pragma once

#include "ui/app/panels/panels.h"

namespace penpose::app {

/// Px that a tour's card takes at the foot of the canvas, `width` px wide; 0: no tour is under way.
[[nodiscard]] double tour_height(const PanelContext& context, double width);
/// What to do next, with its buttons.
void show_tour(PanelContext& context, const Area& area);
/// The line to draw, or a ring around what is to be pressed. Call it when all panels are there.
void show_tour_ghost(PanelContext& context);
/// Buttons that begin the tours, each in a row of its own.
void show_tour_buttons(PanelContext& context);

}  // namespace penpose::app
