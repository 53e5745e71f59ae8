#include "ui/app/tools/sketch_steps.h"

namespace penpose::app {

using articulation::CurveRole;

std::string to_draw_for(CurveRole step) {
  switch (step) {
    case CurveRole::general:
      return "draw around everything on the face that may move";
    case CurveRole::specific:
      return "draw around the part that moves fully, inside the first line";
    case CurveRole::reference:
      return "draw along the feature, on the face";
    case CurveRole::target:
      break;
  }
  return "draw a line where the feature should go";
}

render::CurveKind line_of(CurveRole step) {
  return step == CurveRole::target ? render::CurveKind::target : render::CurveKind::reference;
}

}  // namespace penpose::app
