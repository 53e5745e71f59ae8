#include "ui/app/tools/tool.h"

// Draw: lines of the face as it should be, in any order; what each is, is found.

namespace penpose::app {

WindowTool draw_tool() {
  return {.kind = drawing::ToolKind::draw,
          .button = {"tool_draw", "Draw", "Draw the face as it should be: each line finds its feature",
                     "C12 12 9M8 8.5L9.5 8.5M14.5 8.5L16 8.5M7.5 14L10 16.5L14 16.5L16.5 14", plain_key('d')},
          .hint = [](const ToolSight& sight) -> std::string {
            if (!sight.document.face)
              return "Draw the face as it should be: a mouth, a brow, a lid; each line finds its feature";
            for (const auto& line : sight.document.face->lines) {
              if (line.feature.empty())
                return "One line is not recognised: touch its name to say what it is, or draw on";
            }
            return "Draw on, or touch a name to say what a line is";
          },
          .to_draw = [](const ToolSight&) -> std::string { return "draw a lip, a brow or a lid where it should be"; },
          .line = [](const ToolSight&) { return render::CurveKind::target; }};
}

}  // namespace penpose::app
