#include "ui/app/tools/tool.h"

// Erase: a line over curves that go.

namespace penpose::app {

WindowTool erase_tool() {
  return {.kind = drawing::ToolKind::erase,
          .button = {"tool_erase", "Erase", "Draw over curves to delete them; so does the pen's other end",
                     "M4 15L13 5L20 11L12 20L8 20Z M9 10L16 16M12 20L20 20", plain_key('e')},
          .hint = [](const ToolSight&) -> std::string { return "Draw over curves to delete them"; },
          .to_draw = [](const ToolSight&) -> std::string { return "draw over a curve to delete it"; },
          .erases = true};
}

}  // namespace penpose::app
