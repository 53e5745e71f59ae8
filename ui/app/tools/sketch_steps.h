#pragma once

#include <string>

#include "core/articulation/edit.h"
#include "ui/render/scene.h"

namespace penpose::app {

/// What to draw next, with the number of the step; empty for the target, where it depends on how references are drawn.
[[nodiscard]] std::string hint_of(articulation::CurveRole step);
/// What to draw for a step of a sketched control, after a stroke that meant nothing.
[[nodiscard]] std::string to_draw_for(articulation::CurveRole step);
/// How the line of a step looks.
[[nodiscard]] render::CurveKind line_of(articulation::CurveRole step);

}  // namespace penpose::app
