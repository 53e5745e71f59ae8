#include "ui/app/tools/tool.h"

// Hold: a line along what stays where it is.

namespace penpose::app {

WindowTool constraint_tool() {
  WindowTool tool;
  tool.kind = drawing::ToolKind::constraint;
  tool.name = "tool_constraint";
  tool.label = "Hold";
  tool.key = plain_key('c');
  tool.tip = "Draw along what should stay where it is";
  tool.icon = "M6 11L18 11L18 20L6 20Z A12 11 4 180 360";
  tool.hint = [](const ToolSight&) -> std::string { return "Draw along what should stay where it is"; };
  tool.to_draw = [](const ToolSight&) -> std::string { return "draw along what should stay, on the face"; };
  return tool;
}

}  // namespace penpose::app
