#include "ui/app/tools/tool.h"

// Select: takes targets, curves and controls in hand, and draws nothing.

namespace penpose::app {
namespace {

std::string hint(const ToolSight& sight) {
  if (sight.performs) return "Pull at a target: time runs while the pen is down, and the face is keyed";
  return "Pull at a target, or move all of it by its middle; touch a curve, or the face to pick its control";
}

}  // namespace

WindowTool select_tool() {
  WindowTool tool;
  tool.kind = drawing::ToolKind::none;
  tool.name = "tool_select";
  tool.label = "Select";
  tool.key = plain_key('s');
  tool.tip = "Drag targets, pick the control under the pen";
  tool.icon = "M6 3L6 18L10 14.5L13 21L15.5 20L12.5 13.5L18 13Z";
  tool.hint = hint;
  tool.selects = true;
  return tool;
}

}  // namespace penpose::app
