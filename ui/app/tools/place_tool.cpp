#include "ui/app/tools/tool.h"

// Place: moves a character of the scene, and draws nothing.

namespace penpose::app {

WindowTool place_tool() {
  return {.kind = drawing::ToolKind::none,
          .button = {"tool_place",
                     "Place",
                     "Move a character of the scene by dragging it",
                     "M12 3L12 21M3 12L21 12M9 6L12 3L15 6M9 18L12 21L15 18M6 9L3 12L6 15M18 9L21 12L18 15",
                     {'g', false, true}},
          .hint = [](const ToolSight& /*sight*/) -> std::string {
            return "Drag a character to where it shall stand; touch another one to work on it";
          },
          .places = true};
}

}  // namespace penpose::app
