#include "ui/app/tools/tool.h"

// Pin: a touch of a point that stays where it is.

namespace penpose::app {

WindowTool pin_tool() {
  WindowTool tool;
  tool.kind = drawing::ToolKind::pin;
  tool.name = "tool_pin";
  tool.label = "Pin";
  tool.key = plain_key('n');
  tool.tip = "Touch one point that should stay where it is";
  tool.icon = "C12 8 4M12 12L12 21";
  tool.hint = [](const ToolSight&) -> std::string { return "Touch a point that should stay where it is"; };
  tool.to_draw = [](const ToolSight&) -> std::string { return "touch the face where it should stay"; };
  return tool;
}

}  // namespace penpose::app
