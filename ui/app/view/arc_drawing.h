#pragma once

#include <span>
#include <vector>

#include "ui/app/playback/arcs.h"
#include "ui/render/scene.h"

namespace penpose::app {

/// Paths over time, with a tick at each frame; that of the moment is larger. `scale`: px of the display for each px of
/// an ordinary one.
void add_arcs(std::vector<render::CurveDrawing>& out, std::span<const ShownArc> arcs, double time_s, float scale);

}  // namespace penpose::app
