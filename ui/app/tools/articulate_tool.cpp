#include "ui/app/controls/controls.h"
#include "ui/app/tools/sketch_steps.h"
#include "ui/app/tools/tool.h"

// Rig: the three or four lines of a new control.

namespace penpose::app {
namespace {

std::string articulate_hint(const ToolSight& sight) {
  if (!sight.document.pending) return "1 of 4: draw around everything that a new control may move";
  const auto step = drawing::next_step(sight.document, sight.tool);
  if (step != articulation::CurveRole::target) return hint_of(step);
  return sight.tool.draw_reference ? "4 of 4: draw where the feature should go"
                                   : "4 of 4: draw where it should go (step 3, the feature, is found for you)";
}

void taken(ToolHand& hand) {
  if (!hand.editing.document().pending) hand.controls.begin();
  hand.panels.controls_tab = true;
}

/// Only a line begins a control; a tap leaves the face as it is.
void moved(ToolHand& hand) {
  const replay::DrawnStroke* stroke = hand.editing.session().pens().current();
  if (hand.editing.document().pending || stroke == nullptr || !stroke->on_canvas || stroke->eraser) return;
  if (!drawing::is_tap(stroke->samples, stroke->view.viewport)) hand.controls.begin();
}

}  // namespace

WindowTool articulate_tool() {
  return {.kind = drawing::ToolKind::articulate,
          .button = {"tool_articulate", "Rig", "Sketch a new control in three or four strokes",
                     "C6 18 2.5C18 6 2.5M8 16L16 8M4 6L10 6M7 3L7 9", plain_key('a')},
          .stands_apart = true,
          .can_be_held = false,
          .hint = articulate_hint,
          .to_draw = [](const ToolSight& sight) { return to_draw_for(drawing::next_step(sight.document, sight.tool)); },
          .preview = ToolPreview::sketch,
          .line = [](const ToolSight& sight) { return line_of(drawing::next_step(sight.document, sight.tool)); },
          .taken = taken,
          .moved = moved};
}

}  // namespace penpose::app
