#include "ui/app/tools/sketch_steps.h"
#include "ui/app/tools/tool.h"

// Redraws one line of an existing control. The control's panel chooses this tool.

namespace penpose::app {
namespace {

using articulation::CurveRole;

std::string redraw_hint(const ToolSight& sight) {
  const std::string& control = sight.tool.deformer;
  switch (sight.tool.role) {
    case CurveRole::general:
      return "Draw around everything that " + control + " may move";
    case CurveRole::specific:
      return "Draw around the part that " + control + " moves fully";
    case CurveRole::reference:
      return "Draw along the feature that " + control + " moves, as it is at rest";
    case CurveRole::target:
      break;
  }
  return "Draw where " + control + " should move the feature";
}

}  // namespace

WindowTool redraw_tool() {
  WindowTool tool;
  tool.kind = drawing::ToolKind::redraw;
  tool.hint = redraw_hint;
  tool.to_draw = [](const ToolSight& sight) { return to_draw_for(sight.tool.role); };
  tool.preview = ToolPreview::sketch;
  tool.line = [](const ToolSight& sight) { return line_of(sight.tool.role); };
  return tool;
}

}  // namespace penpose::app
