#include "core/sound/resample.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/sound_files.h"

namespace penpose::sound {
namespace {

class Rates : public ::testing::TestWithParam<int> {};

TEST_P(Rates, AToneIsTheSameTone) {
  const Sound out = resampled({GetParam(), tests::tone(1000, GetParam(), 1)}, 16000);
  const auto expected = tests::tone(1000, 16000, 1);
  ASSERT_NEAR(static_cast<double>(out.samples.size()), static_cast<double>(expected.size()), 1);
  // The filter reaches over the ends, where there is silence.
  for (std::size_t i = 300; i + 300 < expected.size(); ++i) ASSERT_NEAR(out.samples[i], expected[i], 2e-3) << i;
}

TEST_P(Rates, WhatTheNewRateCannotHoldIsGone) {
  const int rate = GetParam();
  if (rate <= 20000) return;
  const Sound out = resampled({rate, tests::tone(9500, rate, 1)}, 16000);
  double loudest = 0;
  for (std::size_t i = 300; i + 300 < out.samples.size(); ++i)
    loudest = std::max(loudest, std::abs(static_cast<double>(out.samples[i])));
  EXPECT_LT(loudest, 0.5e-3) << "60 dB below the tone";
}

INSTANTIATE_TEST_SUITE_P(Sounds, Rates, ::testing::Values(8000, 11025, 16000, 22050, 44100, 48000, 96000));

TEST(Resampling, SilenceStaysSilenceAndNothingStaysNothing) {
  EXPECT_TRUE(resampled({48000, {}}, 16000).samples.empty());
  for (const float sample : resampled({48000, std::vector<float>(4800)}, 16000).samples) EXPECT_EQ(sample, 0.0F);
}

}  // namespace
}  // namespace penpose::sound
