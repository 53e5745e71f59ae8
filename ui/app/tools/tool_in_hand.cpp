#include "ui/app/tools/tool_in_hand.h"

#include <utility>

namespace penpose::app {

const WindowTool& ToolInHand::now() const {
  const drawing::ToolKind kind = parts_.editing.editor().tool().kind;
  return chosen_ != nullptr && chosen_->kind == kind ? *chosen_ : window_tool(kind);
}

void ToolInHand::take(const WindowTool& tool) {
  chosen_ = &tool;
  drawing::Tool drawn;
  drawn.kind = tool.kind;
  parts_.playback.stop();
  parts_.editing.shown().preview(std::nullopt);
  parts_.editing.set_tool(drawn);
  parts_.panels.curve_menu.reset();
  if (tool.kind != drawing::ToolKind::none) parts_.panels.controls_tab = false;
  ToolHand hand{parts_.editing, parts_.controls, parts_.panels};
  if (tool.taken != nullptr) tool.taken(hand);
}

std::string ToolInHand::hint() const {
  if (parts_.performer.performing()) return "Recording frame by frame: lift the pen to end the take";
  const WindowTool& tool = now();
  if (tool.hint == nullptr) return {};
  return tool.hint(
      {parts_.editing.document(), parts_.editing.editor().tool(), parts_.playback.while_drawing().performs});
}

void ToolInHand::press(PxPoint at) { line_ = {at}; }

void ToolInHand::move(PxPoint at) {
  line_.push_back(at);
  ToolHand hand{parts_.editing, parts_.controls, parts_.panels};
  if (const WindowTool& tool = now(); tool.moved != nullptr) tool.moved(hand);
}

void ToolInHand::release() {
  const auto line = std::exchange(line_, {});
  const WindowTool& tool = now();
  if (tool.means == nullptr || line.empty()) return;
  const auto command = tool.means({parts_.editing.document(), parts_.editing.editor().view(), line});
  if (command) parts_.editing.perform(*command);
}

}  // namespace penpose::app
