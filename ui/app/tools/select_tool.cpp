#include "ui/app/tools/tool.h"

// Select: takes targets, curves and controls in hand, and draws nothing.

namespace penpose::app {

WindowTool select_tool() {
  return {.kind = drawing::ToolKind::none,
          .button = {"tool_select", "Select", "Drag targets, pick the control under the pen",
                     "M6 3L6 18L10 14.5L13 21L15.5 20L12.5 13.5L18 13Z", plain_key('s')},
          .hint = [](const ToolSight& sight) -> std::string {
            if (sight.performs) return "Pull a target: time runs while the pen is down, and the face is keyed";
            return "Pull a target, or drag its middle to move all of it; touch a curve, or touch the face to pick its "
                   "control";
          },
          .selects = true,
          .performs = true};
}

}  // namespace penpose::app
