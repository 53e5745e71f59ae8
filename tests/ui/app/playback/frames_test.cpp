#include "ui/app/playback/frames.h"

#include <gtest/gtest.h>
#include <vector>

namespace penpose::app {
namespace {

TEST(Frames, MomentsSnapToTheFramesOfEveryRate) {
  for (const int rate : k_frame_rates) {
    EXPECT_DOUBLE_EQ(on_frame(7.4 / rate, rate), 7.0 / rate);
    EXPECT_DOUBLE_EQ(on_frame(7.6 / rate, rate), 8.0 / rate);
    EXPECT_EQ(frame_text(7.0 / rate, rate), "7");
  }
  EXPECT_EQ(frame_text(0.5 / 24, 24), "0.5");
}

TEST(Frames, ARateIsReadFromTheMomentsOfKeys) {
  EXPECT_EQ(rate_of(std::vector{0.0, 1.0 / 24, 2.0}), 24);
  EXPECT_EQ(rate_of(std::vector{0.0, 3.0 / 25}), 25);
  EXPECT_EQ(rate_of(std::vector{0.0, 7.0 / 30}), 30);
  EXPECT_EQ(rate_of(std::vector{0.0, 1.0 / 48}), 48);
  EXPECT_EQ(rate_of(std::vector{0.0, 1.0 / 60}), 60);
  EXPECT_EQ(rate_of(std::vector{0.0, 0.1234}), std::nullopt) << "of no rate";
  EXPECT_EQ(rate_of(std::vector{0.0}), std::nullopt) << "the beginning lies on frames of any rate";
}

TEST(Frames, AFrameOrSecondsAreTyped) {
  EXPECT_EQ(typed_moment("36", 24), 1.5);
  EXPECT_EQ(typed_moment(" 36 ", 48), 0.75);
  EXPECT_EQ(typed_moment("1.5s", 24), 1.5);
  EXPECT_EQ(typed_moment("1.5 s", 30), 1.5);
  for (const char* wrong : {"", "s", "x", "3f", "nan", "inf"})
    EXPECT_EQ(typed_moment(wrong, 24), std::nullopt) << wrong;
}

TEST(Frames, AStepFromBetweenTwoFramesGoesToTheNeighbour) {
  EXPECT_DOUBLE_EQ(step_frame(10.0 / 24, 1, 24), 11.0 / 24);
  EXPECT_DOUBLE_EQ(step_frame(10.0 / 24, -1, 24), 9.0 / 24);
  EXPECT_DOUBLE_EQ(step_frame(10.4 / 24, 1, 24), 11.0 / 24);
  EXPECT_DOUBLE_EQ(step_frame(10.4 / 24, -1, 24), 10.0 / 24);
}

}  // namespace
}  // namespace penpose::app
