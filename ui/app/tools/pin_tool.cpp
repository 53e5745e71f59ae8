#include "ui/app/tools/tool.h"

// Pin: a touch of a point that stays where it is.

namespace penpose::app {

WindowTool pin_tool() {
  return {.kind = drawing::ToolKind::pin,
          .button = {"tool_pin", "Pin", "Touch one point that should stay where it is", "C12 8 4M12 12L12 21",
                     plain_key('n')},
          .hint = [](const ToolSight&) -> std::string { return "Touch a point that should stay where it is"; },
          .to_draw = [](const ToolSight&) -> std::string { return "touch the face where it should stay"; }};
}

}  // namespace penpose::app
