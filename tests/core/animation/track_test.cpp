#include "core/animation/track.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::animation {
namespace {

TEST(Track, TimesInMillisecondsAreWholeFramesOfTheVideosRate) {
  for (const double fps : {25.0, 30.0, 30000 / 1001.0}) {
    std::vector<double> times;
    for (int f = 0; f < 200; ++f) times.push_back(std::round(1000 * f / fps) / 1000);
    const double found = whole_frame_rate(times, 0.3);
    EXPECT_NEAR(found, fps, 1e-9);
    const auto whole = at_whole_frames(times, found);
    for (int f = 0; f < 200; ++f) EXPECT_NEAR(whole[static_cast<std::size_t>(f)] * fps, f, 1e-9);
  }
}

TEST(Track, AClockThatGoesALittleWrongKeepsTheRateThatIsMeant) {
  for (const double frames : {60, 5000}) {
    std::vector<double> times;
    for (int f = 0; f < static_cast<int>(frames); ++f) times.push_back(f / 29.99);
    EXPECT_EQ(whole_frame_rate(times, 0.3), 30) << frames;
    const auto whole = at_whole_frames(times, 30);
    for (std::size_t f = 0; f < whole.size(); ++f) EXPECT_NEAR(whole[f], static_cast<double>(f) / 30, 1e-9) << f;
    times.clear();
    for (int f = 0; f < static_cast<int>(frames); ++f) times.push_back(f / 29.97);
    EXPECT_NEAR(whole_frame_rate(times, 0.3), 29.97, 1e-4) << frames;
  }
}

TEST(Track, UnevenTimesHaveNoRate) {
  EXPECT_EQ(whole_frame_rate(std::vector<double>{0, 0.04, 0.095, 0.12}, 0.3), 0);
  EXPECT_EQ(whole_frame_rate(std::vector<double>{0.5}, 0.3), 0);
  EXPECT_EQ(whole_frame_rate(std::vector<double>{0, 0, 0}, 0.3), 0);
}

TEST(Track, FramesThatAreLeftOutKeepTheRate) {
  EXPECT_EQ(whole_frame_rate(std::vector<double>{0, 0.04, 0.08, 0.4, 0.44}, 0.3), 25);
}

}  // namespace
}  // namespace penpose::animation
