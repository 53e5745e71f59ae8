#include "ui/app/view/user_messages.h"

#include <algorithm>
#include <array>

#include "ui/app/tools/tool.h"

namespace penpose::app {

std::string message_of(const base::Error& error) {
  return error.what + (error.remedy.empty() ? "" : "; " + error.remedy);
}

std::string message_of_stroke(const base::Error& error, const drawing::Tool& tool, const document::Document& before) {
  if (error.place == "view" && before.pending) return "The view has turned: draw both lines around it in one view";
  if (error.place.starts_with("line/core") || error.place.starts_with("line/general")) return message_of(error);
  constexpr std::array k_not_meant{"line", "at", "role", "feature", ""};
  if (std::find(k_not_meant.begin(), k_not_meant.end(), error.place) == k_not_meant.end()) return message_of(error);
  const WindowTool& window = window_tool(tool.kind);
  return k_nothing_changed +
         (window.to_draw != nullptr ? window : window_tool(drawing::ToolKind::pose)).to_draw({before, tool});
}

}  // namespace penpose::app
