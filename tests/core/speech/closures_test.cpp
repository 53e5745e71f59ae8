#include "core/speech/closures.h"

#include <gtest/gtest.h>

#include "tests/support/sound_files.h"

namespace penpose::speech {
namespace {

/// A tone that falls silent from one moment to another.
sound::Sound gap(double from_s, double to_s, double rest = 0) {
  sound::Sound sound{16000, tests::tone(600, 16000, 1)};
  for (std::size_t i = 0; i < sound.samples.size(); ++i) {
    const double time = static_cast<double>(i) / 16000;
    if (time >= from_s && time < to_s) sound.samples[i] *= static_cast<float>(rest);
  }
  return sound;
}

TEST(Closures, LipsCloseWhereTheSoundFallsAndOpenWhereItRises) {
  const Cues told{{0.1, "A"}, {0.47, "closed"}, {0.53, "E"}, {0.9, "rest"}};
  for (const double rest : {0.0, 0.05}) {
    const Cues found = with_closures(told, gap(0.5, 0.56, rest));
    EXPECT_NEAR(found[1].time_s, 0.5, 0.012) << rest;
    EXPECT_NEAR(found[2].time_s, 0.56, 0.012) << rest;
    EXPECT_EQ(found[0], told[0]);
    EXPECT_EQ(found[3], told[3]);
  }
}

TEST(Closures, TheyStayWhereNothingFallsOrItIsTooFar) {
  const Cues told{{0.1, "A"}, {0.47, "closed"}, {0.53, "E"}, {0.9, "rest"}};
  EXPECT_EQ(with_closures(told, gap(0, 0)), told);
  for (const Cue& cue : with_closures(told, gap(0.7, 0.76))) {
    const auto same = std::find_if(told.begin(), told.end(), [&](const Cue& one) { return one.mouth == cue.mouth; });
    EXPECT_NEAR(cue.time_s, same->time_s, k_farthest_s + 1e-9);
  }
}

TEST(Closures, MomentsStayInOrderWhateverTheSound) {
  const Cues crowded{{0.48, "A"}, {0.49, "closed"}, {0.5, "E"}, {0.505, "closed"}, {0.51, "rest"}};
  const Cues found = with_closures(crowded, gap(0.46, 0.58));
  for (std::size_t i = 1; i < found.size(); ++i) EXPECT_GE(found[i].time_s, found[i - 1].time_s) << i;
  EXPECT_EQ(with_closures({{0, "closed"}}, sound::Sound{16000, {}}), (Cues{{0, "closed"}}));
}

TEST(Closures, LoudnessIsThatOfTheSamples) {
  const auto loudness = loudness_of(gap(0.5, 0.56));
  ASSERT_NEAR(static_cast<double>(loudness.size()), 200, 1);
  EXPECT_EQ(loudness[106], -100);
  EXPECT_GT(loudness[50], -40);
}

}  // namespace
}  // namespace penpose::speech
