#include "ui/app/tools/tool.h"

// Ghost: the face at another moment is drawn as it should be there. GhostHand does it, which knows what is seen.

namespace penpose::app {
WindowTool ghost_tool() {
  return {.kind = drawing::ToolKind::none,
          .button = {"tool_ghost", "Ghosts", "Draw on the face before and after: the moment that is drawn on is posed",
                     "M5 20L5 10A12 10 7 180 360M19 10L19 20L15.5 17L12 20L8.5 17L5 20M9.5 10L9.5 12M14.5 10L14.5 12"},
          .to_draw = [](const ToolSight&) -> std::string { return "draw near a line of a ghost, as it should be"; },
          .line = [](const ToolSight&) { return render::CurveKind::target; },
          .shows_ghosts = true,
          .means = [](const ToolLine&) -> std::optional<document::Command> { return std::nullopt; }};
}

}  // namespace penpose::app
