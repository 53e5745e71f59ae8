#include "core/sound/peaks.h"

#include <gtest/gtest.h>

#include "tests/support/sound_files.h"

namespace penpose::sound {
namespace {

/// Silence with one loud sample.
Sound click(std::size_t count, std::size_t at) {
  Sound sound{8000, std::vector<float>(count)};
  sound.samples[at] = 0.75F;
  return sound;
}

TEST(Peaks, AClickIsSeenAtEveryWidthOfTheView) {
  const Sound sound = click(800'000, 500'123);
  const Peaks peaks(sound);
  const double at = 500'123.5 / 8000;
  for (double width = 1.0 / 8000; width < 200; width *= 3) {
    EXPECT_EQ(peaks.between(sound, at - width / 3, at + width).high, 0.75F) << width;
    EXPECT_EQ(peaks.between(sound, at - 1.5 * width - 0.001, at - width / 2 - 0.001).high, 0.0F) << width;
  }
}

TEST(Peaks, LowAndHighAreThoseOfTheSamples) {
  const Sound sound{48000, tests::tone(440, 48000, 2)};
  const Peaks peaks(sound);
  EXPECT_NEAR(peaks.between(sound, 0, 2).high, 0.5, 1e-3);
  EXPECT_NEAR(peaks.between(sound, 0, 2).low, -0.5, 1e-3);
  // A quarter of the tone's period: it only rises.
  EXPECT_EQ(peaks.between(sound, 0, 0.25 / 440).low, 0.0F);
}

TEST(Peaks, OutsideOfTheSoundIsSilence) {
  const Sound sound{8000, std::vector<float>(100, 1.0F)};
  const Peaks peaks(sound);
  EXPECT_EQ(peaks.between(sound, -2, -1), Peak{});
  EXPECT_EQ(peaks.between(sound, 1, 2), Peak{});
  EXPECT_EQ(peaks.between(sound, -1, 2).high, 1.0F);
  EXPECT_EQ(Peaks(Sound{}).between(Sound{}, 0, 1), Peak{});
}

}  // namespace
}  // namespace penpose::sound
