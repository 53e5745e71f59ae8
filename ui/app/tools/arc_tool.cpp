#include "ui/app/tools/tool.h"

// Arc: the path of a curve's middle over time is redrawn, or its frames are pulled along it.

namespace penpose::app {

WindowTool arc_tool() {
  return {.kind = drawing::ToolKind::none,
          .button = {"tool_arc", "Arc", "Redraw the paths of features over time, and pull their frames",
                     "A12 20 10 200 340M6 15L4 11M12 12L12 7M18 15L20 11", plain_key('w')},
          .hint = [](const ToolSight& sight) -> std::string {
            if (sight.document.timeline->keys.size() < 2)
              return "Key two poses first: then the way between them is an arc";
            if (sight.performs) return "Redraw a part of an arc at the pace that it should have";
            return "Redraw a part of an arc from one of its frames to another, or pull a frame along it";
          },
          .to_draw = [](const ToolSight&) -> std::string {
            return "begin on a frame of an arc and end on another one of it";
          },
          .shows_arcs = true,
          .performs = true,
          .means = [](const ToolLine& line) -> std::optional<document::Command> {
            const auto command = arc_meant(line.document, line.arcs, line.view, line.points, line.shares, line.paced,
                                           line.rate, line.within_px);
            if (!command) return std::nullopt;
            return document::Command(*command);
          }};
}

}  // namespace penpose::app
