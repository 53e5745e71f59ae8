#include "ui/app/tools/tool.h"

// Hold: a line along what stays where it is.

namespace penpose::app {

WindowTool constraint_tool() {
  return {.kind = drawing::ToolKind::constraint,
          .button = {"tool_constraint", "Hold", "Draw along what should stay where it is",
                     "M6 11L18 11L18 20L6 20Z A12 11 4 180 360", plain_key('c')},
          .hint = [](const ToolSight&) -> std::string { return "Draw along what should stay where it is"; },
          .to_draw = [](const ToolSight&) -> std::string { return "draw along what should stay, on the face"; }};
}

}  // namespace penpose::app
