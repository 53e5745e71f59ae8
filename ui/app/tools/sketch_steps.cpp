#include "ui/app/tools/sketch_steps.h"

namespace penpose::app {

using articulation::CurveRole;

namespace {

struct Step {
  const char* hint;
  const char* to_draw;
};

/// By CurveRole.
constexpr Step k_steps[] = {
    {"1 of 4: draw around everything that may move", "draw around everything on the face that may move"},
    {"2 of 4: draw around the part that moves fully", "draw around the part that moves fully, inside the first line"},
    {"3 of 4: draw along the feature as it is now", "draw along the feature, on the face"},
    {"", "draw a line where the feature should go"}};

const Step& step_of(CurveRole role) { return k_steps[static_cast<std::size_t>(role)]; }

}  // namespace

std::string hint_of(CurveRole step) { return step_of(step).hint; }

std::string to_draw_for(CurveRole step) { return step_of(step).to_draw; }

render::CurveKind line_of(CurveRole step) {
  return step == CurveRole::target ? render::CurveKind::target : render::CurveKind::reference;
}

}  // namespace penpose::app
