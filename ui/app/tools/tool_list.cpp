#include <algorithm>
#include <array>

#include "ui/app/tools/tool.h"

namespace penpose::app {

// Each stands in a file of this folder. A new one is that file, a line here and a row below.
WindowTool draw_tool();
WindowTool pose_tool();
WindowTool oversketch_tool();
WindowTool constraint_tool();
WindowTool pin_tool();
WindowTool erase_tool();
WindowTool select_tool();
WindowTool articulate_tool();
WindowTool redraw_tool();
WindowTool between_tool();
WindowTool arc_tool();
WindowTool ghost_tool();
WindowTool feature_tool();
WindowTool perform_tool();
WindowTool place_tool();

std::span<const WindowTool> window_tools() {
  static const std::array all{
      draw_tool(),    pose_tool(),   oversketch_tool(), constraint_tool(), pin_tool(),
      erase_tool(),   select_tool(), articulate_tool(), arc_tool(),        ghost_tool(),
      feature_tool(), place_tool(),  redraw_tool(),     between_tool(),    perform_tool(),
  };
  return all;
}

const WindowTool& window_tool(drawing::ToolKind kind) {
  const auto tools = window_tools();
  const auto found = std::find_if(tools.begin(), tools.end(), [&](const WindowTool& one) { return one.kind == kind; });
  return found == tools.end() ? window_tool(drawing::ToolKind::pose) : *found;
}

}  // namespace penpose::app
