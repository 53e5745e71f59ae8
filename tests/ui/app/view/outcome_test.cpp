#include "ui/app/view/outcome.h"

#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

namespace penpose::app {
namespace {

TEST(Outcome, WhatIsLeftIsSaidFirstAndThenWhatMoved) {
  Desk desk("outcome");
  desk.begin();
  EXPECT_EQ(outcome_of(desk.app->of<EditingSession>()), "");
  pose_mouth(desk);
  const std::string text = outcome_of(desk.app->of<EditingSession>());
  char left[32];
  std::snprintf(left, sizeof left, "%.1f px left", desk.app->of<EditingSession>().last_stroke().left_px());
  EXPECT_TRUE(text.starts_with(left)) << text;
  auto& editing = desk.app->of<EditingSession>();
  EXPECT_NE(text.find("Moved " + editing.words_of(editing.last_stroke().movements().front().name)), std::string::npos)
      << text;
}

TEST(Outcome, AControlThatCanGoNoFurtherIsNamed) {
  Desk desk("outcome-limit");
  desk.begin();
  const auto raised = desk.named_curve("brow_L", {0, -45});
  desk.stroke(desk.named_curve("brow_L"));
  desk.stroke(raised);
  const auto& movements = desk.app->of<EditingSession>().last_stroke().movements();
  const auto at_limit = std::find_if(movements.begin(), movements.end(), [](const auto& one) { return one.at_limit; });
  ASSERT_NE(at_limit, movements.end()) << "no brow goes that far";
  const std::string text = outcome_of(desk.app->of<EditingSession>());
  EXPECT_NE(text.find(desk.app->of<EditingSession>().words_of(at_limit->name)), std::string::npos) << text;
  EXPECT_TRUE(text.find("at its limit") != std::string::npos || text.find("at their limits") != std::string::npos)
      << text;
}

TEST(Outcome, ALineOfWhichAPartWasLeftOutIsSaidSo) {
  std::vector<PxPoint> line;
  {
    Desk desk("outcome-kept");
    desk.begin();
    line = desk.named_curve("brow_L");
    desk.stroke(line);
    for (const auto& one : desk.app->of<Notices>().all())
      EXPECT_EQ(one.text.find("% of the line"), std::string::npos) << one.text;
  }
  // On, and far out of the face.
  if (line.front().x > line.back().x) std::reverse(line.begin(), line.end());
  line.push_back({line.back().x + 400, line.back().y});
  Desk desk("outcome-cut");
  desk.begin();
  desk.stroke(line);
  const auto notices = desk.app->of<Notices>().all();
  ASSERT_FALSE(notices.empty());
  EXPECT_NE(notices.back().text.find("% of the line was kept"), std::string::npos) << notices.back().text;
}

}  // namespace
}  // namespace penpose::app
