#include "ui/app/view/user_messages.h"

#include <algorithm>

namespace penpose::app {
namespace {

using articulation::CurveRole;

std::string of_step(CurveRole step) {
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

std::string what_to_draw(const drawing::Tool& tool, const document::Document& before) {
  switch (tool.kind) {
    case drawing::ToolKind::articulate:
      return of_step(drawing::next_step(before, tool));
    case drawing::ToolKind::redraw:
      return of_step(tool.role);
    case drawing::ToolKind::between:
      return of_step(CurveRole::target);
    case drawing::ToolKind::oversketch: {
      const bool has = std::any_of(before.curves.begin(), before.curves.end(), [](const auto& c) { return c->target; });
      return has ? "draw over the part of the blue line that should change" : "draw where a feature should go first";
    }
    case drawing::ToolKind::constraint:
      return "draw along what should stay, on the face";
    case drawing::ToolKind::pin:
      return "touch the face where it should stay";
    case drawing::ToolKind::erase:
      return "draw over a curve to delete it";
    default:
      break;
  }
  const bool waits = std::any_of(before.curves.begin(), before.curves.end(), [](const auto& curve) {
    return curve->role == document::PoseCurveRole::reference && !curve->target;
  });
  return waits ? "draw a line where the feature should go" : "draw along a feature of the face";
}

}  // namespace

std::string message_of(const base::Error& error) {
  return error.what + (error.remedy.empty() ? "" : "; " + error.remedy);
}

std::string message_of_stroke(const base::Error& error, const drawing::Tool& tool, const document::Document& before) {
  if (error.place == "view" && before.pending) return "The view has turned: draw both lines around it in one view";
  if (error.place.starts_with("line/core") || error.place.starts_with("line/general")) return message_of(error);
  if (error.place != "line" && error.place != "at" && error.place != "role" && !error.place.empty())
    return message_of(error);
  return k_nothing_changed + what_to_draw(tool, before);
}

}  // namespace penpose::app
