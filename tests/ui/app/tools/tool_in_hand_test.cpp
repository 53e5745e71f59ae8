#include "ui/app/tools/tool_in_hand.h"

#include <gtest/gtest.h>
#include <set>

#include "tests/support/app_desk.h"

// Tools of the window: all that there is to one stands in its own file.

namespace penpose::app {
namespace {

TEST(ToolInHand, EveryToolWithAButtonHasItsWordsAndAKeyOfItsOwn) {
  std::set<std::uint32_t> keys;
  for (const WindowTool& tool : window_tools()) {
    EXPECT_TRUE(tool.hint != nullptr || tool.shows_ghosts) << tool.button.label << ": what is drawn on says it";
    if (tool.button.label.empty()) continue;
    EXPECT_EQ(info({tool.button.action}).tool, &tool) << tool.button.label << " is an action, too";
    EXPECT_FALSE(tool.button.tip.empty() || tool.button.icon.empty()) << tool.button.label;
    EXPECT_TRUE(tool.draws() || tool.selects || tool.pulls || tool.places) << tool.button.label << " does nothing";
    EXPECT_TRUE(keys.insert(tool.button.key.key).second) << tool.button.label;
  }
}

TEST(ToolInHand, AToolOfTheWindowAloneSaysWhatItsLineMeans) {
  Desk desk("own-tool");
  desk.begin();
  WindowTool tool;
  tool.hint = [](const ToolSight&) -> std::string { return "Draw around nothing"; };
  tool.means = [](const ToolLine& line) -> std::optional<document::Command> {
    return document::Pin{line.view, line.points.back()};
  };
  ToolInHand& hand = desk.app->of<ToolInHand>();
  hand.take(tool);
  EXPECT_EQ(hand.hint(), "Draw around nothing");
  const auto line = desk.named_curve(any_curve(desk));
  desk.stroke(line);
  ASSERT_EQ(desk.document().curves.size(), 1U);
  EXPECT_EQ(desk.document().curves.front()->role, document::PoseCurveRole::constraint);
  desk.app->of<EditingSession>().steps().undo();
  EXPECT_TRUE(desk.document().curves.empty()) << "one step takes it back";
  // It is no tool of the table, and another one takes its place.
  desk.click("Select");
  EXPECT_TRUE(hand.now().selects);
}

}  // namespace
}  // namespace penpose::app
