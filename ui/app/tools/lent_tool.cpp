#include "ui/app/tools/lent_tool.h"

#include <utility>

namespace penpose::app {

void LentTool::lend(const drawing::Tool& tool) {
  if (!lent()) before_ = editing_.editor().tool();
  tool_ = tool;
  pressed_revision_ = editing_.revision();
  editing_.set_tool(tool);
}

void LentTool::give_back() {
  const bool still = lent();
  const auto before = std::exchange(before_, std::nullopt);
  if (still) editing_.set_tool(*before);
}

void LentTool::release() {
  if (lent() && editing_.revision() != pressed_revision_) give_back();
}

}  // namespace penpose::app
