#include "core/sound/mix.h"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace penpose::sound {
namespace {

const Sound k_steps{4000, {0.1F, 0.2F, 0.3F, 0.4F}};

std::vector<float> mixed(double offset_s, std::int64_t first, std::size_t count) {
  std::vector<float> out(count, 9.0F);
  mix(k_steps, offset_s, first, out);
  return out;
}

TEST(Mix, GivesTheSamplesOfAMoment) {
  EXPECT_EQ(mixed(0, 0, 4), k_steps.samples);
  EXPECT_EQ(mixed(0, 1, 2), (std::vector<float>{0.2F, 0.3F}));
}

TEST(Mix, IsSilentAroundTheSound) {
  EXPECT_EQ(mixed(0, -2, 3), (std::vector<float>{0, 0, 0.1F}));
  EXPECT_EQ(mixed(0, 3, 3), (std::vector<float>{0.4F, 0, 0}));
  EXPECT_EQ(mixed(0, 1'000'000'000'000, 2), (std::vector<float>{0, 0}));
  EXPECT_EQ(mixed(0, -1'000'000'000'000, 2), (std::vector<float>{0, 0}));
}

TEST(Mix, AnOffsetDelaysTheSoundOrCutsItsBeginning) {
  EXPECT_EQ(mixed(2.0 / 4000, 0, 4), (std::vector<float>{0, 0, 0.1F, 0.2F}));
  EXPECT_EQ(mixed(-2.0 / 4000, 0, 4), (std::vector<float>{0.3F, 0.4F, 0, 0}));
}

TEST(Mix, BlocksFollowEachOtherWithoutAGap) {
  std::vector<float> whole = mixed(0.25 / 4000, -3, 12);
  std::vector<float> blocks;
  for (std::int64_t first = -3; first < 9; first += 3) {
    for (const float sample : mixed(0.25 / 4000, first, 3)) blocks.push_back(sample);
  }
  EXPECT_EQ(blocks, whole);
}

TEST(Mix, SlowedDownEachSampleLastsLongerAndBlocksFollowWithoutAGap) {
  const auto slowed = [](std::int64_t first, double speed, std::size_t count) {
    std::vector<float> out(count, 9.0F);
    mix_slowed(k_steps, 0, first, speed, out);
    return out;
  };
  EXPECT_EQ(slowed(0, 1, 4), k_steps.samples);
  const std::vector<float> half = slowed(0, 0.5, 7);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(half[2 * i], k_steps.samples[i]) << "twice as late";
  EXPECT_NEAR(half[1], 0.15F, 1e-6);
  const std::vector<float> whole = slowed(-5, 0.25, 24);
  std::vector<float> blocks;
  for (std::int64_t first = -5; first < 19; first += 3) {
    for (const float sample : slowed(first, 0.25, 3)) blocks.push_back(sample);
  }
  EXPECT_EQ(blocks, whole);
}

TEST(Mix, MomentsBecomeTheNearestSample) {
  EXPECT_EQ(sample_of(1.0 / 24, 48000), 2000);
  EXPECT_EQ(sample_of(-1, 48000), -48000);
  EXPECT_EQ(sample_of(std::numeric_limits<double>::quiet_NaN(), 48000), 0);
  EXPECT_GT(sample_of(std::numeric_limits<double>::infinity(), 48000), 0);
}

TEST(Mix, SnippetsBeginAndEndInSilence) {
  std::vector<float> snippet(100, 1.0F);
  fade_ends(snippet, 10);
  EXPECT_EQ(snippet.front(), 0.0F);
  EXPECT_EQ(snippet.back(), 0.0F);
  EXPECT_EQ(snippet[50], 1.0F);
  std::vector<float> one(1, 1.0F);
  fade_ends(one, 10);
  EXPECT_EQ(one[0], 1.0F);
}

}  // namespace
}  // namespace penpose::sound
