#include "ui/film/film_sound.h"

#include <gtest/gtest.h>

#include "core/sound/read/read_sound.h"

namespace penpose::film {
namespace {

/// Samples that say where they come from.
sound::Sound counted(int rate_hz, std::size_t count) {
  sound::Sound sound;
  sound.rate_hz = rate_hz;
  for (std::size_t i = 0; i < count; ++i) sound.samples.push_back(static_cast<float>(i + 1) / 65536.0F);
  return sound;
}

TEST(FilmSound, LastsAsLongAsItsFrames) {
  const sound::Sound sound = counted(44100, 1000);
  for (const double rate : {24.0, 25.0, 23.976, 60.0}) {
    for (const std::size_t frames : {1, 7, 48}) {
      const auto part = *sound_of_frames(sound, 0, 5, frames, rate);
      EXPECT_NEAR(static_cast<double>(part.samples.size()), static_cast<double>(frames) / rate * 44100, 1.0);
      EXPECT_EQ(part.rate_hz, 44100);
    }
  }
}

TEST(FilmSound, BeginsWhereTheTimelineHasIt) {
  const sound::Sound sound = counted(48000, 48000);
  // The film begins on frame 12, half a second in.
  const auto later = *sound_of_frames(sound, 0.75, 12, 24, 24);
  ASSERT_EQ(later.samples.size(), 48000U);
  EXPECT_EQ(later.samples[11999], 0) << "silent for the first quarter of a second";
  EXPECT_EQ(later.samples[12000], sound.samples[0]);
  EXPECT_EQ(later.samples[47999], sound.samples[35999]) << "cut at the end of the film";
  const auto before = *sound_of_frames(sound, -0.25, 12, 24, 24);
  EXPECT_EQ(before.samples[0], sound.samples[36000]);
  EXPECT_EQ(before.samples[11999], sound.samples[47999]);
  EXPECT_EQ(before.samples[12000], 0) << "silent once the sound is over";
  const auto away = *sound_of_frames(sound, 100, 0, 24, 24);
  EXPECT_EQ(away.samples, std::vector<float>(48000, 0.0F));
}

TEST(FilmSound, OfDaysIsRefused) { EXPECT_FALSE(sound_of_frames(counted(48000, 10), 0, 0, 1'000'000, 24).ok()); }

TEST(FilmSound, IsReadBackToTheSample) {
  const sound::Sound sound = counted(22050, 3000);
  const auto bytes = wav_bytes(sound);
  EXPECT_EQ(bytes.size(), 44 + 4 * sound.samples.size());
  const auto read = sound::read_sound(bytes);
  if (!read) GTEST_SKIP() << read.error().line();
  EXPECT_EQ(*read, sound);
}

}  // namespace
}  // namespace penpose::film
