#include <algorithm>

#include "ui/app/tools/tool.h"

// Redraw: a line over the part of a target that should change.

namespace penpose::app {
namespace {

std::string oversketch_to_draw(const ToolSight& sight) {
  const auto& curves = sight.document.curves;
  const bool has = std::any_of(curves.begin(), curves.end(), [](const auto& one) { return one->target.has_value(); });
  return has ? "draw over the part of the blue line that should change" : "draw where a feature should go first";
}

}  // namespace

WindowTool oversketch_tool() {
  return {.kind = drawing::ToolKind::oversketch,
          .button = {"tool_oversketch", "Redraw", "Draw over a part of the last target",
                     "M3 18L9 13L13 16M14 13L20 4L22 6L16 14L13 15Z", plain_key('o')},
          .hint = [](const ToolSight&) -> std::string {
            return "Draw over the part of the last target that should change";
          },
          .to_draw = oversketch_to_draw,
          .performs = true};
}

}  // namespace penpose::app
