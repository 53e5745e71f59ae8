#include "ui/live/live.h"

#include <gtest/gtest.h>
#include <string>

namespace penpose::live {
namespace {

TEST(Live, ALiveOutputIsToldOfEveryFrameWhereItWasAskedFor) {
  std::string opened;
  std::vector<double> told;
  const LiveOutput ways[] = {{"one", "HOST", [&](std::string_view where) -> base::Result<Listener> {
                                opened = where;
                                return Listener([&](const FramePose& pose) { told.push_back(pose.values[0]); });
                              }}};
  const auto listener = open_live_output("one=here:9000", ways);
  ASSERT_TRUE(listener.ok());
  EXPECT_EQ(opened, "here:9000");
  const double value = 0.25;
  (*listener)({{}, {&value, 1}, 1});
  EXPECT_EQ(told, std::vector<double>{0.25});
  EXPECT_TRUE(open_live_output("one", ways).ok());
  EXPECT_EQ(opened, "");
}

TEST(Live, WithoutAWayNothingIsTold) {
  const auto listener = open_live_output("", {});
  ASSERT_TRUE(listener.ok());
  (*listener)({});
}

TEST(Live, AWayThatIsNotThereIsRefused) {
  const LiveOutput ways[] = {{"one", "HOST", nullptr}};
  const auto listener = open_live_output("two=here", ways);
  ASSERT_FALSE(listener.ok());
  EXPECT_EQ(listener.error().remedy, "there are: one");
}

}  // namespace
}  // namespace penpose::live
