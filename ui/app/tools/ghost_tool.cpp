#include "ui/app/playback/ghosts.h"
#include "ui/app/tools/tool.h"

// Ghost: the face at a neighbouring key, which is seen as lines, is drawn as it should be at that moment.

namespace penpose::app {
namespace {

std::string ghost_hint(const ToolSight& sight) {
  if (sight.document.timeline->keys.size() < 2)
    return "Key two poses first: then the neighbouring one is seen as lines";
  return "Draw where a line of the key before (violet) or after (cyan) should be: that moment is changed";
}

}  // namespace

WindowTool ghost_tool() {
  return {
      .kind = drawing::ToolKind::none,
      .button = {"tool_ghost", "Ghosts", "Draw on the keys before and after: the moment that is drawn on is changed",
                 "M5 20L5 10A12 10 7 180 360M19 10L19 20L15.5 17L12 20L8.5 17L5 20M9.5 10L9.5 12M14.5 10L14.5 12"},
      .hint = ghost_hint,
      .to_draw = [](const ToolSight&) -> std::string { return "draw where a line of a ghost should be, near to it"; },
      .line = [](const ToolSight&) { return render::CurveKind::target; },
      .shows_ghosts = true,
      .means = [](const ToolLine& line) -> std::optional<document::Command> {
        const auto edit = ghost_meant(line.document, line.view, line.points);
        if (!edit) return std::nullopt;
        return command_of(line.document, *edit);
      }};
}

}  // namespace penpose::app
