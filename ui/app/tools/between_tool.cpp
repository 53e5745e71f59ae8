#include "core/base/numbers.h"
#include "ui/app/tools/sketch_steps.h"
#include "ui/app/tools/tool.h"

// Another target of a control, at a value of its own. The control's panel takes this tool.

namespace penpose::app {

WindowTool between_tool() {
  WindowTool tool;
  tool.kind = drawing::ToolKind::between;
  tool.hint = [](const ToolSight& sight) {
    return "Draw where the feature should be when " + sight.tool.deformer + " is at " +
           base::format_fixed(sight.tool.value, 2);
  };
  tool.to_draw = [](const ToolSight&) { return to_draw_for(articulation::CurveRole::target); };
  tool.preview = ToolPreview::sketch;
  return tool;
}

}  // namespace penpose::app
