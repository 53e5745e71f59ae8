#include "ui/app/sound/sound_track.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

#include "core/sound/mix.h"
#include "tests/support/app_desk.h"
#include "tests/support/sound_files.h"

namespace penpose::app {
namespace {

/// A device that takes samples in blocks, some while after they were due, as real ones do.
class Device final : public SoundOutput {
 public:
  struct Log {
    std::vector<float> queue;
    std::vector<float> heard;
    int opened = 0;
    bool open = false;
    bool broken = false;
  };
  explicit Device(Log& log) : log_(log) {}
  base::Status open(int) override {
    if (log_.broken) return base::Error{"there is no sound device", "", ""};
    log_.open = true;
    ++log_.opened;
    return base::Done{};
  }
  void close() override { log_.open = false; }
  void push(std::span<const float> samples) override {
    log_.queue.insert(log_.queue.end(), samples.begin(), samples.end());
  }
  void clear() override { log_.queue.clear(); }
  [[nodiscard]] std::size_t waiting() const override { return log_.queue.size(); }
  [[nodiscard]] std::size_t underway() const override { return 0; }

 private:
  Log& log_;
};

constexpr int k_rate_hz = 8000;

class SoundTrackOfDesk : public ::testing::Test {
 protected:
  explicit SoundTrackOfDesk() : desk_("sound") {
    desk_.begin();
    write("talk.wav", 2);
    track().set_output(std::make_unique<Device>(log_));
  }
  std::string path(const std::string& name) const { return (desk_.folder / name).string(); }
  void write(const std::string& name, double duration_s) const {
    const auto bytes = tests::wav_bytes(tests::tone(440, k_rate_hz, duration_s), k_rate_hz);
    std::ofstream file(path(name), std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  SoundTrack& track() { return desk_.app->of<SoundTrack>(); }
  Playback& playback() { return desk_.app->of<Playback>(); }
  /// A frame of the window, in which the device, whose clock goes by another pace, plays on.
  void frame(double pace = 1) {
    desk_.frames(1);
    heard_at_picture_ = log_.heard.size();
    due_ += 0.016 * k_rate_hz * pace;
    while (due_ >= k_block) {
      due_ -= k_block;
      const std::size_t count = std::min<std::size_t>(k_block, log_.queue.size());
      log_.heard.insert(log_.heard.end(), log_.queue.begin(), log_.queue.begin() + static_cast<std::ptrdiff_t>(count));
      log_.queue.erase(log_.queue.begin(), log_.queue.begin() + static_cast<std::ptrdiff_t>(count));
    }
  }

  static constexpr std::size_t k_block = 85;
  Desk desk_;
  Device::Log log_;
  double due_ = 0;
  std::size_t heard_at_picture_ = 0;  ///< what the device had taken when the last frame was made
};

TEST_F(SoundTrackOfDesk, AnOpenedSoundIsInTheDocumentAndIsUndone) {
  track().open(path("talk.wav"));
  ASSERT_NE(desk_.document().sound, nullptr);
  EXPECT_EQ(desk_.document().sound->file, std::filesystem::weakly_canonical(path("talk.wav")).string());
  ASSERT_NE(track().sound(), nullptr);
  EXPECT_NEAR(track().sound()->duration_s(), 2, 1e-3);
  EXPECT_FALSE(log_.open) << "no device until something sounds";
  playback().undo();
  desk_.frames();
  EXPECT_EQ(track().sound(), nullptr);
  playback().redo();
  desk_.frames();
  EXPECT_NE(track().sound(), nullptr) << "found again by its name";
}

TEST_F(SoundTrackOfDesk, ItIsPlayedSampleBySampleFromTheCursor) {
  track().open(path("talk.wav"));
  playback().scrub(0.5);
  desk_.frames(1);
  log_.queue.clear();
  playback().play_or_stop();
  for (int i = 0; i < 40; ++i) frame();
  ASSERT_GT(log_.heard.size(), 4000U);
  const auto tone = track().sound()->samples;
  // The first frame comes 16 ms after the key was pressed.
  const auto first = static_cast<std::size_t>(sound::sample_of(0.516, k_rate_hz));
  for (std::size_t i = 0; i < 4000; ++i) ASSERT_EQ(log_.heard[i], tone[first + i]) << i;
}

TEST_F(SoundTrackOfDesk, AtHalfTheSpeedItIsHeardTwiceAsSlowAndThePictureGoesAlong) {
  track().open(path("talk.wav"));
  desk_.app->of<Actions>().run(Action{"play_speed"});
  ASSERT_EQ(playback().speed(), 0.5);
  playback().go_to(0.5);
  desk_.frames(1);
  log_.heard.clear();
  log_.queue.clear();
  playback().play_or_stop();
  for (int i = 0; i < 60; ++i) frame();
  const double passed_s = 0.016 * 60;
  EXPECT_NEAR(playback().time_s(), 0.5 + 0.5 * passed_s, 0.5 / 24);
  ASSERT_GT(log_.heard.size(), 6000U);
  const auto& tone = track().sound()->samples;
  // The first frame comes 16 ms after the key was pressed.
  const auto first = static_cast<std::size_t>(std::lround((0.5 + 0.5 * 0.016) * k_rate_hz));
  for (std::size_t i = 0; i < 2000; ++i) ASSERT_NEAR(log_.heard[2 * i], tone[first + i], 1e-6) << i;
  // Back to the whole speed while it plays: no jump.
  const double before_s = playback().time_s();
  playback().set_speed(1);
  frame();
  EXPECT_NEAR(playback().time_s(), before_s + 0.016, 0.5 / 24);
}

TEST_F(SoundTrackOfDesk, ThePictureFollowsWhatIsHeardToHalfAFrame) {
  for (const double pace : {0.97, 1.0, 1.03}) {
    track().open(path("talk.wav"));
    write("long.wav", 40);
    track().open(path("long.wav"));
    playback().go_to(0);
    desk_.frames(1);
    log_.heard.clear();
    log_.queue.clear();
    playback().play_or_stop();
    for (int i = 0; i < 600; ++i) {
      frame(pace);
      const double heard_s = 0.016 + static_cast<double>(heard_at_picture_) / k_rate_hz;
      if (i > 20) {
        ASSERT_NEAR(playback().time_s(), heard_s, 0.5 / 24) << pace << " frame " << i;
      }
    }
    playback().stop();
    desk_.frames(1);
  }
}

TEST_F(SoundTrackOfDesk, ACursorThatIsMovedSoundsForAFrameAndThenTheDeviceIsLetGo) {
  track().open(path("talk.wav"));
  desk_.frames();
  playback().scrub(1);
  desk_.frames(1);
  EXPECT_NEAR(static_cast<double>(log_.queue.size()), k_rate_hz / 24.0, 2);
  EXPECT_TRUE(log_.open);
  for (int i = 0; i < 70; ++i) frame();
  EXPECT_FALSE(log_.open) << "an idle window takes no time";
  EXPECT_EQ(track().next_frame_ms(), -1);
  track().mute(true);
  playback().scrub(1.5);
  desk_.frames(1);
  EXPECT_FALSE(log_.open);
}

TEST_F(SoundTrackOfDesk, AMutedSoundStopsAtOnceAndGoesOnInTime) {
  track().open(path("talk.wav"));
  playback().play_or_stop();
  for (int i = 0; i < 10; ++i) frame();
  track().mute(true);
  desk_.frames(1);
  EXPECT_TRUE(log_.queue.empty());
  track().mute(false);
  desk_.frames(1);
  const double now = playback().time_s();
  ASSERT_FALSE(log_.queue.empty());
  EXPECT_EQ(log_.queue.front(), track().sound()->samples[static_cast<std::size_t>(sound::sample_of(now, k_rate_hz))]);
}

TEST_F(SoundTrackOfDesk, ASoundThatIsGoneOrAnotherIsToldAndStaysInTheDocument) {
  track().open(path("talk.wav"));
  ASSERT_TRUE(desk_.app->of<Files>().save(path("project.glb")).ok());
  const auto notice = [&](const std::string& words) {
    const auto& all = desk_.app->of<Notices>().all();
    return std::any_of(all.begin(), all.end(),
                       [&](const Notice& one) { return one.text.find(words) != std::string::npos; });
  };
  write("talk.wav", 1);
  ASSERT_TRUE(desk_.app->of<Files>().open(path("project.glb")).ok());
  desk_.frames();
  EXPECT_TRUE(notice("another one than the project was made with"));
  EXPECT_NEAR(track().sound()->duration_s(), 1, 1e-3);
  std::filesystem::remove(path("talk.wav"));
  ASSERT_TRUE(desk_.app->of<Files>().open(path("project.glb")).ok());
  desk_.frames();
  EXPECT_EQ(track().sound(), nullptr);
  EXPECT_NE(desk_.document().sound, nullptr);
  EXPECT_TRUE(notice("talk.wav"));
}

TEST_F(SoundTrackOfDesk, ASoundThatWasOpenedBeforeTheFirstSaveIsNamedFromTheProject) {
  track().open(path("talk.wav"));
  desk_.frames();
  ASSERT_TRUE(std::filesystem::path(desk_.document().sound->file).is_absolute());
  const auto before = track().shared_sound();
  ASSERT_TRUE(desk_.app->of<Files>().save(path("project.glb")).ok());
  EXPECT_EQ(desk_.document().sound->file, "talk.wav");
  EXPECT_FALSE(desk_.app->of<EditingSession>().unsaved());
  desk_.frames();
  EXPECT_EQ(track().shared_sound(), before) << "the same samples play on";
  // The folder as a whole may go elsewhere.
  const std::filesystem::path moved = desk_.folder / "elsewhere";
  std::filesystem::create_directory(moved);
  std::filesystem::rename(path("talk.wav"), moved / "talk.wav");
  std::filesystem::rename(path("project.glb"), moved / "project.glb");
  ASSERT_TRUE(desk_.app->of<Files>().open((moved / "project.glb").string()).ok());
  desk_.frames();
  ASSERT_NE(track().sound(), nullptr);
  // Saved where the sound is not below it, the whole path finds it.
  std::filesystem::create_directory(desk_.folder / "other");
  ASSERT_TRUE(desk_.app->of<Files>().save((desk_.folder / "other" / "project.glb").string()).ok());
  ASSERT_TRUE(desk_.app->of<Files>().open((desk_.folder / "other" / "project.glb").string()).ok());
  desk_.frames();
  EXPECT_NE(track().sound(), nullptr);
  EXPECT_TRUE(std::filesystem::path(desk_.document().sound->file).is_absolute());
}

TEST_F(SoundTrackOfDesk, ASaveThatFailsLeavesTheSoundAsItIsNamed) {
  track().open(path("talk.wav"));
  const std::string named = desk_.document().sound->file;
  EXPECT_FALSE(desk_.app->of<Files>().save(path("no/such/folder/project.glb")).ok());
  EXPECT_EQ(desk_.document().sound->file, named);
}

TEST_F(SoundTrackOfDesk, WithoutADeviceTheTimelinePlaysInSilence) {
  log_.broken = true;
  track().open(path("talk.wav"));
  playback().play_or_stop();
  for (int i = 0; i < 10; ++i) frame();
  EXPECT_TRUE(playback().playing());
  EXPECT_GT(playback().time_s(), 0.1);
}

TEST_F(SoundTrackOfDesk, TheStripIsDraggedAndMuted) {
  EXPECT_EQ(desk_.interface->find("sound"), nullptr);
  track().open(path("talk.wav"));
  desk_.frames();
  const Area area = *desk_.interface->find("sound");
  auto& pointer = desk_.app->of<Pointer>();
  pointer.moved(area.middle());
  pointer.button(MouseButton::left, true, area.middle());
  desk_.frames();
  const PxPoint to{area.middle().x + 0.25 * area.width(), area.middle().y};
  pointer.moved(to);
  desk_.frames();
  EXPECT_EQ(desk_.document().sound->offset_s, 0) << "not before it is let go";
  EXPECT_GT(track().offset_s(), 0.5);
  pointer.button(MouseButton::left, false, to);
  desk_.frames();
  EXPECT_GT(desk_.document().sound->offset_s, 0.5);
  EXPECT_LT(desk_.document().sound->offset_s, 2);
  desk_.click("Mute");
  EXPECT_TRUE(track().muted());
}

}  // namespace
}  // namespace penpose::app
