#include "ui/app/tools/tool.h"

// Erase: a line over curves that go.

namespace penpose::app {

WindowTool erase_tool() {
  WindowTool tool;
  tool.kind = drawing::ToolKind::erase;
  tool.name = "tool_erase";
  tool.label = "Erase";
  tool.key = plain_key('e');
  tool.tip = "Draw over curves to delete them; so does the pen's other end";
  tool.icon = "M4 15L13 5L20 11L12 20L8 20Z M9 10L16 16M12 20L20 20";
  tool.hint = [](const ToolSight&) -> std::string { return "Draw over curves to delete them"; };
  tool.to_draw = [](const ToolSight&) -> std::string { return "draw over a curve to delete it"; };
  tool.erases = true;
  return tool;
}

}  // namespace penpose::app
