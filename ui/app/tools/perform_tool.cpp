#include "ui/app/tools/tool.h"

// Perform: whatever is under the pen is pulled like a puppet's string while time runs, and what the face does is keyed.
// Its button stands beside the timeline, where time is.

namespace penpose::app {

WindowTool perform_tool() {
  return {.kind = drawing::ToolKind::none,
          .can_be_held = false,
          .hint = [](const ToolSight&) -> std::string {
            return "Press on the face and pull: time runs while the pen is down, and the face is recorded";
          },
          .pulls = true,
          .performs = true};
}

}  // namespace penpose::app
