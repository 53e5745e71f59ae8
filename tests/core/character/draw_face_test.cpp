#include <gtest/gtest.h>

#include "tests/support/models/laughing_head.h"
#include "tests/support/models/sheet_model.h"

namespace penpose::tests {
namespace {

double value_of(const character::Character& one, const char* name) {
  return one.pose()[rig::find_parameter(one.parameters(), name).value()];
}

std::vector<std::string> names_of(const character::DrawnFace& drawn) {
  std::vector<std::string> out;
  for (const portrait::LineRead& line : drawn.read.lines)
    out.push_back(line.curve ? drawn.features.curves[*line.curve].name : "");
  return out;
}

TEST(DrawFace, TheFaceTakesWhatTheDrawingShowsByOneCommand) {
  for (const double yaw : {0.0, 25.0}) {
    const LaughingHead laugh(yaw);
    auto head = demo_character();
    std::vector<document::Command> heard;
    head.listen([&](std::span<const document::Command> commands, std::span<const document::Document>) -> base::Status {
      heard.insert(heard.end(), commands.begin(), commands.end());
      return base::Done{};
    });
    const auto drawn = head.draw_face({laugh.lines, {}}, laugh.view);
    ASSERT_TRUE(drawn) << drawn.error().line();
    EXPECT_GE(laugh.right(names_of(*drawn)), laugh.names.size() - 1) << yaw;
    EXPECT_NEAR(value_of(head, "jaw"), LaughingHead::k_jaw, 0.2) << yaw;
    EXPECT_NEAR(value_of(head, "mouth_corner_L"), LaughingHead::k_corner, 0.3) << yaw;
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(document::name_of(heard.front()), "set_parameters");
  }
}

TEST(DrawFace, ItIsReadFromRestAndWhatIsLockedStays) {
  const LaughingHead laugh;
  auto head = demo_character();
  ASSERT_TRUE(head.draw_face({laugh.lines, {}}));
  const auto first = head.state();
  ASSERT_TRUE(head.perform(document::SetParameters{{{"jaw", 0.1}, {"mouth_corner_L", 0.0}}}));
  ASSERT_TRUE(head.draw_face({laugh.lines, {}}));
  EXPECT_EQ(head.state(), first);
  ASSERT_TRUE(head.perform(document::SetParameters{{{"jaw", 0.1}}}));
  ASSERT_TRUE(head.perform(document::LockParameters{{"jaw"}, true}));
  ASSERT_TRUE(head.draw_face({laugh.lines, {}}));
  EXPECT_EQ(value_of(head, "jaw"), 0.1);
}

TEST(DrawFace, WhatIsRefusedChangesNothing) {
  const LaughingHead laugh;
  auto head = demo_character();
  const auto before = head.state();
  EXPECT_FALSE(head.draw_face({}));
  EXPECT_FALSE(head.draw_face({{{{1, 1}}}, {}}));
  EXPECT_FALSE(head.draw_face({laugh.lines, {{}}}));
  EXPECT_FALSE(head.draw_face({laugh.lines, {}}, document::View{{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 30}, {10, 10}}));
  EXPECT_EQ(head.state(), before);
  character::Character sheet(document::make_document(sheet_model()));
  EXPECT_FALSE(sheet.draw_face({laugh.lines, {}})) << "it has no face";
}

}  // namespace
}  // namespace penpose::tests
