#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/document/commands/apply.h"
#include "core/document/history.h"
#include "core/sound/read/read_sound.h"
#include "tests/support/command_run.h"
#include "tests/support/sound_files.h"
#include "ui/cli/commands.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"
#include "ui/files/sound/sound_file.h"
#include "ui/film/ffmpeg.h"
#include "ui/render/picture/image.h"

namespace penpose::cli {
namespace {

constexpr int k_rate_hz = 48000;

/// What a program prints.
std::string printed(const std::string& call) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(call.c_str(), "r"), ::pclose);
  std::string text;
  char block[1 << 14];
  for (std::size_t got = 0; pipe && (got = std::fread(block, 1, sizeof block, pipe.get())) > 0;)
    text.append(block, got);
  return text;
}

class FilmCommand : public tests::CommandRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    auto document = files::load_document("builtin:demo");
    ASSERT_TRUE(document.ok());
    history_.emplace(std::move(document).value());
    const std::string control = history_->document().model->rig->parameters().front().name;
    perform(document::SetKey{0, "", {}});
    perform(document::KeyPoses{{control}, {0.5, 1.0}, {1.0, 0.0}});
  }
  template <typename Command>
  void perform(const Command& command) {
    document::ApplyWorkspace work;
    const auto done = history_->perform(command, work);
    ASSERT_TRUE(done.ok()) << done.error().line();
  }
  /// A sound with one click at a moment, beside the timeline from another moment on. False: this build reads none.
  bool lay_sound(double click_s, double duration_s, double offset_s) {
    std::vector<float> samples(static_cast<std::size_t>(duration_s * k_rate_hz));
    const auto at = static_cast<std::size_t>(click_s * k_rate_hz);
    // A burst that survives what codecs leave out.
    for (std::size_t i = at; i < std::min(samples.size(), at + 960); ++i)
      samples[i] = 0.8F * std::sin(static_cast<float>(i - at) * 0.2F);
    save("talk.wav", tests::wav_bytes(samples, k_rate_hz));
    const auto loaded = files::load_sound(path("talk.wav"), path("clip.glb"));
    if (!loaded) return false;
    perform(document::SetSound{loaded->reference.file, loaded->reference.content, offset_s});
    return true;
  }
  void save_project() {
    const auto saved = files::save_document(history_->document(), path("clip.glb"), files::SaveNotes::quiet);
    ASSERT_TRUE(saved.ok()) << saved.error().line();
  }
  int film(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {path("clip.glb"), "--draw", "cpu"});
    return run("film", arguments);
  }
  [[nodiscard]] std::string probed(const std::string& name, const std::string& entries, const std::string& more = "") {
    return printed("ffprobe -v error " + more + " -show_entries " + entries + " -of default=nw=1:nk=1 " + path(name) +
                   " 2>&1");
  }
  [[nodiscard]] render::Image picture(const std::string& name) {
    const std::string bytes = content(name);
    const auto image = render::decode_png(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    EXPECT_TRUE(image.ok()) << name;
    return image ? *image : render::Image{};
  }
  /// When its first loud sample is heard, s; -1: never.
  [[nodiscard]] double loud_at(const std::string& name) {
    const std::string raw = printed("ffmpeg -v error -i " + path(name) + " -map 0:a -ac 1 -ar 48000 -f f32le - ");
    std::vector<float> samples(raw.size() / 4);
    std::copy_n(raw.data(), samples.size() * 4, reinterpret_cast<char*>(samples.data()));
    const auto loud = std::find_if(samples.begin(), samples.end(), [](float one) { return std::abs(one) > 0.3F; });
    return loud == samples.end() ? -1 : static_cast<double>(loud - samples.begin()) / 48000;
  }

  std::optional<document::History> history_;
};

TEST_F(FilmCommand, WritesItsPicturesByTheNumbersOfTheirFrames) {
  save_project();
  ASSERT_EQ(film({"--size", "64x48", "--from", "3", "--to", "6", "-o", path("out/clip.png")}), k_success) << error_;
  EXPECT_EQ(out_ + error_, "");
  std::set<std::string> names;
  for (const auto& one : std::filesystem::directory_iterator(path("out"))) names.insert(one.path().filename().string());
  EXPECT_EQ(names, (std::set<std::string>{"clip0003.png", "clip0004.png", "clip0005.png", "clip0006.png"}));
  EXPECT_EQ(picture("out/clip0003.png").width, 64);
  EXPECT_NE(content("out/clip0003.png"), content("out/clip0006.png")) << "the face moves";
}

TEST_F(FilmCommand, DrawsWhatRenderDraws) {
  save_project();
  ASSERT_EQ(film({"--size", "64x48", "--from", "12", "--to", "12", "-o", path("a.png")}), k_success) << error_;
  ASSERT_EQ(run("render", {path("clip.glb"), "--frames", "--draw", "cpu", "--size", "64x48", "-o", path("b.png")}),
            k_success)
      << error_;
  const auto ours = picture("a0012.png"), theirs = picture("b0013.png");
  int differ = 0;
  for (std::size_t i = 0; i < ours.pixels.size(); ++i)
    differ += std::abs(ours.pixels[i] - theirs.pixels[i]) > 8 ? 1 : 0;
  EXPECT_LT(differ, 100);
}

TEST_F(FilmCommand, NumbersAndPartsAreInThePicture) {
  save_project();
  const std::vector<std::string> frames{"--size", "200x120", "--to", "0"};
  const auto with = [&](const char* name, std::vector<std::string> more) {
    more.insert(more.begin(), frames.begin(), frames.end());
    more.insert(more.end(), {"-o", path(name)});
    EXPECT_EQ(film(more), k_success) << error_;
  };
  with("plain.png", {});
  with("numbers.png", {"--numbers"});
  with("part.png", {"--crop", "80x60+40+20"});
  with("light.png", {"--light"});
  EXPECT_GT(picture("light0000.png").at(0, 0)[0], 200) << "the ground is light";
  const auto plain = picture("plain0000.png"), numbers = picture("numbers0000.png"), part = picture("part0000.png");
  ASSERT_EQ(part.width, 80);
  ASSERT_EQ(part.height, 60);
  for (const auto& [x, y] : {std::pair{0, 0}, std::pair{79, 59}, std::pair{40, 30}})
    EXPECT_EQ(part.at(x, y)[1], plain.at(40 + x, 20 + y)[1]);
  int changed = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (numbers.at(x, y)[0] == plain.at(x, y)[0]) continue;
      ++changed;
      EXPECT_LT(x, 60);
      EXPECT_GT(y, 80);
    }
  }
  EXPECT_GT(changed, 50);
}

TEST_F(FilmCommand, SheetsHaveTheKeyedFramesOrEveryNth) {
  save_project();
  ASSERT_EQ(film({"--sheet", "keys", "--size", "60x40", "-o", path("keys.png")}), k_success) << error_;
  ASSERT_EQ(film({"--sheet", "4", "--size", "60x40", "-o", path("fourth.png")}), k_success) << error_;
  // Keys on 0, 12 and 24, in rows of two; every fourth of 25 frames are seven, in rows of four.
  const auto keys = picture("keys.png"), fourth = picture("fourth.png");
  EXPECT_EQ(keys.width, 2 * 68 + 8);
  EXPECT_EQ(fourth.width, 4 * 68 + 8);
  EXPECT_EQ(film({"--sheet", "keys", "--from", "1", "--to", "3", "-o", path("none.png")}), k_failure);
  EXPECT_NE(error_.find("keyed"), std::string::npos);
  EXPECT_EQ(film({"--sheet", "keys", "-o", path("none.mp4")}), k_failure);
  EXPECT_FALSE(std::filesystem::exists(path("none.png")));
}

TEST_F(FilmCommand, VideosHaveTheirLengthRateAndSound) {
  if (!film::has_ffmpeg()) GTEST_SKIP() << "no ffmpeg";
  // The click is at 0.9 s of the timeline; the film begins on frame 6, at 0.25 s.
  const bool sounds = lay_sound(0.4, 3, 0.5);
  save_project();
  for (const char* name : {"clip.mp4", "clip.webm"}) {
    ASSERT_EQ(film({"--size", "64x48", "--from", "6", "--to", "41", "-o", path(name)}), k_success) << error_;
    EXPECT_EQ(error_, "");
    EXPECT_EQ(probed(name, "stream=r_frame_rate,width,height", "-select_streams v"), "64\n48\n24/1\n") << name;
    EXPECT_EQ(probed(name, "stream=nb_read_frames", "-count_frames -select_streams v"), "36\n") << name;
    EXPECT_NEAR(std::atof(probed(name, "format=duration").c_str()), 1.5, 0.03) << name;
    if (!sounds) continue;
    EXPECT_EQ(probed(name, "stream=sample_rate", "-select_streams a"), "48000\n") << name;
    const double begins_s = std::atof(probed(name, "stream=start_time", "-select_streams v").c_str());
    EXPECT_NEAR(std::atof(probed(name, "stream=start_time", "-select_streams a").c_str()), begins_s, 0.004) << name;
    EXPECT_NEAR(loud_at(name), 0.65, 0.005) << name;
  }
  ASSERT_EQ(film({"--size", "64x48", "--silent", "-o", path("silent.mp4")}), k_success) << error_;
  EXPECT_EQ(probed("silent.mp4", "stream=codec_type", "-select_streams a"), "");
  EXPECT_EQ(files(), sounds ? 5U : 4U) << "nothing lies around";
}

TEST_F(FilmCommand, GifsKeepTheirLengthAtAnyRate) {
  if (!film::has_ffmpeg()) GTEST_SKIP() << "no ffmpeg";
  save_project();
  for (const auto& [fps, frames, shown] : {std::tuple{"24", "24", "24"}, std::tuple{"60", "60", "30"}}) {
    ASSERT_EQ(
        film({"--size", "64x48", "--fps", fps, "--to", std::to_string(std::atoi(frames) - 1), "-o", path("clip.gif")}),
        k_success)
        << error_;
    EXPECT_NEAR(std::atof(probed("clip.gif", "format=duration").c_str()), 1.0, 0.05) << fps;
    EXPECT_EQ(probed("clip.gif", "stream=nb_read_frames", "-count_frames"), std::string(shown) + "\n");
  }
}

TEST_F(FilmCommand, ASoundThatIsGoneIsNamedAndTheFilmIsSilent) {
  if (!film::has_ffmpeg()) GTEST_SKIP() << "no ffmpeg";
  if (!lay_sound(0.1, 1, 0)) GTEST_SKIP() << "no sound is read";
  save_project();
  std::filesystem::remove(path("talk.wav"));
  ASSERT_EQ(film({"--size", "64x48", "-o", path("clip.mp4")}), k_success) << error_;
  EXPECT_NE(error_.find("talk.wav"), std::string::npos) << error_;
  EXPECT_NE(error_.find("silent"), std::string::npos) << error_;
  EXPECT_EQ(probed("clip.mp4", "stream=codec_type"), "video\n");
  // One that was asked for by name is missed.
  EXPECT_EQ(film({"--sound", path("talk.wav"), "-o", path("other.mp4")}), k_failure);
  EXPECT_FALSE(std::filesystem::exists(path("other.mp4")));
}

TEST_F(FilmCommand, WithoutFfmpegFilmsAreRefusedAndPicturesAreNot) {
  save_project();
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", path("empty").c_str(), 1);
  for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
    EXPECT_EQ(film({"--size", "64x48", "-o", path(name)}), k_failure);
    EXPECT_NE(error_.find("install the package ffmpeg"), std::string::npos) << error_;
    EXPECT_FALSE(std::filesystem::exists(path(name)));
  }
  EXPECT_EQ(film({"--size", "64x48", "--to", "1", "-o", path("a.png")}), k_success) << error_;
  ::setenv("PATH", before.c_str(), 1);
}

TEST_F(FilmCommand, AnFfmpegThatFailsIsQuotedAndNothingIsLeft) {
  save_project();
  save("clip.mp4", "the old film");
  std::filesystem::create_directory(path("bin"));
  save("bin/ffmpeg", "#!/bin/sh\necho first >&2\necho 'Unknown encoder: no such thing' >&2\nexit 1\n");
  std::filesystem::permissions(path("bin/ffmpeg"), std::filesystem::perms::owner_all);
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", (path("bin") + ":" + before).c_str(), 1);
  EXPECT_EQ(film({"--size", "64x48", "-o", path("clip.mp4")}), k_failure);
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_NE(error_.find("(Unknown encoder: no such thing)"), std::string::npos) << error_;
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
  EXPECT_EQ(content("clip.mp4"), "the old film");
  EXPECT_EQ(files(), 3U);
}

TEST_F(FilmCommand, FailuresAreOneLineAndLeaveNoFile) {
  save_project();
  save("bare.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const auto fails = [&](std::vector<std::string> arguments, const char* word) {
    EXPECT_EQ(run("film", arguments), k_failure);
    EXPECT_NE(error_.find(word), std::string::npos) << error_;
    EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
  };
  const std::string clip = path("clip.glb");
  fails({path("bare.off"), "-o", path("x.png")}, "nothing to film");
  fails({clip, "-o", path("x.avi")}, ".webm");
  fails({clip, "-o", path("clip.glb")}, "clip.glb");
  fails({clip, "--from", "9", "--to", "3", "-o", path("x.png")}, "before the first");
  fails({clip, "--size", "64x48", "--crop", "60x40+10+0", "-o", path("x.png")}, "--crop");
  save("file", "");
  fails({clip, "-o", path("file/x.png")}, "folder");
  if (film::has_ffmpeg()) {
    std::filesystem::create_directory(path("folder.mp4"));
    fails({clip, "-o", path("folder.mp4")}, "folder");
    fails({clip, "-o", path("nowhere/x.mp4")}, "cannot be written");
    std::filesystem::remove(path("folder.mp4"));
  }
  EXPECT_EQ(files(), 3U);
  for (const char* crop : {"64x48", "0x4+0+0", "4x4+0+0x", "-4x4+0+0"})
    EXPECT_EQ(film({"--crop", crop, "-o", path("x.png")}), k_wrong_usage) << crop;
}

}  // namespace
}  // namespace penpose::cli
