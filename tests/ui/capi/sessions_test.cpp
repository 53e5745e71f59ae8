#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "tests/support/c_desk.h"
#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/usb_capture.h"

namespace penpose::tests {
namespace {

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The hash that a session of the project comes to on every machine.
std::string golden(const std::string& name) {
  std::ifstream file(std::string(PENPOSE_SOURCE) + "/tests/golden/hashes.txt");
  for (std::string one, hash; file >> one >> hash;) {
    if (one == name) return hash;
  }
  return "no golden hash of " + name;
}

TEST(CSessions, GoldenSessionsComeToTheirStates) {
  CDesk desk;
  const std::string glb = read_text(PENPOSE_SOURCE + std::string("/tests/data/models/test_sheet.glb"));
  penpose_handle sheet = 0;
  ASSERT_EQ(penpose_character_read(desk.open, glb.data(), glb.size(), nullptr, &sheet, &desk.error), PENPOSE_OK)
      << desk.error.message;
  const std::pair<const char*, penpose_handle> sessions[] = {{"/ui/demo/demo.session", 0},
                                                             {"/tests/data/sessions/penpartner.session", 0},
                                                             {"/tests/data/sessions/suggest.session", sheet}};
  for (const auto& [path, on] : sessions) {
    const std::string text = read_text(PENPOSE_SOURCE + std::string(path));
    penpose_handle made = 0;
    penpose_playback playback{};
    ASSERT_EQ(penpose_session_play(desk.open, text.data(), text.size(), on, &made, &playback, &desk.error), PENPOSE_OK)
        << path << ": " << desk.error.message;
    const std::string name = std::string(path).substr(std::string(path).rfind('/') + 1);
    EXPECT_EQ(playback.state, golden(name)) << path;
    EXPECT_EQ(desk.state(made), golden(name)) << path;
    EXPECT_EQ(playback.differing, 0U);
  }
}

TEST(CSessions, WhatIsRecordedReplaysToTheSameBits) {
  CDesk desk;
  penpose_handle as_it_was = 0;
  ASSERT_EQ(penpose_character_copy(desk.open, desk.sheet, &as_it_was, nullptr), PENPOSE_OK);
  std::size_t size = 0;
  EXPECT_EQ(penpose_recorded(desk.open, desk.sheet, nullptr, 0, &size, nullptr), PENPOSE_REFUSED);
  ASSERT_EQ(penpose_record(desk.open, desk.sheet, "sheet.glb", nullptr), PENPOSE_OK);
  const auto to = desk.line(-0.5, 0.6, 0.5, 0.6);
  const std::uint32_t curve = desk.draw(desk.line(-0.5, 0.5, 0.5, 0.5));
  ASSERT_EQ(penpose_target_stroke(desk.open, desk.sheet, curve, &desk.view, to.data(), nullptr, to.size() / 2, nullptr),
            PENPOSE_OK);
  static_cast<void>(desk.place_lift(0.25));
  EXPECT_EQ(penpose_set_parameter(desk.open, desk.sheet, "lean", 7, nullptr), PENPOSE_REFUSED);
  for (const std::int32_t preset : {PENPOSE_PRESET_PAPER, PENPOSE_PRESET_EXACT, PENPOSE_PRESET_DEFAULT})
    ASSERT_EQ(penpose_solve(desk.open, desk.sheet, preset, nullptr), PENPOSE_OK);
  ASSERT_EQ(penpose_perform(desk.open, desk.sheet, "set_key time_s=1 name=lifted", nullptr), PENPOSE_OK);

  ASSERT_EQ(penpose_recorded(desk.open, desk.sheet, nullptr, 0, &size, nullptr), PENPOSE_OK);
  std::string text(size, ' ');
  EXPECT_EQ(penpose_recorded(desk.open, desk.sheet, text.data(), size - 1, &size, nullptr), PENPOSE_TOO_SMALL);
  ASSERT_EQ(penpose_recorded(desk.open, desk.sheet, text.data(), size, &size, nullptr), PENPOSE_OK);
  penpose_handle again = 0;
  penpose_playback playback{};
  ASSERT_EQ(penpose_session_play(desk.open, text.data(), size, as_it_was, &again, &playback, &desk.error), PENPOSE_OK)
      << desk.error.message;
  EXPECT_EQ(playback.steps, 8U) << "what was refused is not in it";
  EXPECT_EQ(playback.checked, 8U);
  EXPECT_EQ(desk.state(again), desk.state());

  // A session that says something else than was done is told, and gives nothing.
  const std::size_t at = text.rfind("state ") + 6;
  text[at] = text[at] == '0' ? '1' : '0';
  penpose_handle none = 77;
  EXPECT_EQ(penpose_session_play(desk.open, text.data(), size, as_it_was, &none, &playback, &desk.error),
            PENPOSE_DIVERGED);
  EXPECT_EQ(none, 77U);
  EXPECT_EQ(playback.differing, 1U);
  EXPECT_EQ(playback.line, static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n')));
  // And one of another character.
  EXPECT_EQ(penpose_session_play(desk.open, text.data(), size, again, &none, &playback, &desk.error), PENPOSE_REFUSED);
  EXPECT_EQ(penpose_session_play(desk.open, text.data(), size, 0, &none, &playback, &desk.error), PENPOSE_REFUSED);
  EXPECT_NE(std::string(desk.error.message).find("sheet.glb"), std::string::npos);
}

/// What the program reads, the library reads: here a session as UTF-16, one in quotes, and a capture of USB.
TEST(CSessions, RecordingsOfEveryKindArePlayed) {
  CDesk desk;
  const auto play = [&](const std::string& bytes, penpose_playback& playback) {
    penpose_handle made = 0;
    return penpose_session_play(desk.open, bytes.data(), bytes.size(), 0, &made, &playback, &desk.error);
  };
  const std::string session = read_text(PENPOSE_SOURCE + std::string("/ui/demo/demo.session"));
  std::string wide = "\xff\xfe";
  std::string quoted = "> ";
  for (const char c : session) {
    wide += {c, '\0'};
    quoted += c;
    if (c == '\n') quoted += "> ";
  }
  for (const std::string& bytes : {wide, quoted}) {
    penpose_playback playback{};
    ASSERT_EQ(play(bytes, playback), PENPOSE_OK) << desk.error.message;
    EXPECT_EQ(playback.state, golden("demo.session"));
  }
  UsbCapture capture;
  const UsbTablet ink{1, 9, 0x1b96, 0x1000, {ink_descriptor()}, {}};
  capture.plug_in(ink);
  for (const auto& sample : pen_path({24188, 15360, 4095, true, -1}, 2)) capture.report(ink, 0, ink_pen(sample));
  const Buffer file = capture.pcap();
  penpose_playback playback{};
  ASSERT_EQ(play(std::string(file.begin(), file.end()), playback), PENPOSE_OK) << desk.error.message;
  EXPECT_EQ(playback.strokes, 2U);
  EXPECT_EQ(play("# libinput record\nversion: 1\nndevices: 1\n", playback), PENPOSE_REFUSED);
  EXPECT_NE(std::string(desk.error.message).find("libinput's recording"), std::string::npos) << desk.error.message;
}

TEST(CSessions, AProjectReadsBackWithItsState) {
  CDesk desk;
  static_cast<void>(desk.place_lift(0.25));
  ASSERT_EQ(penpose_solve(desk.open, desk.sheet, 0, nullptr), PENPOSE_OK);
  std::size_t size = 0;
  ASSERT_EQ(penpose_write(desk.open, desk.sheet, ".glb", nullptr, 0, &size, nullptr), PENPOSE_OK);
  std::vector<std::uint8_t> bytes(size);
  ASSERT_EQ(penpose_write(desk.open, desk.sheet, ".glb", bytes.data(), size, &size, nullptr), PENPOSE_OK);
  penpose_handle again = 0;
  ASSERT_EQ(penpose_character_read(desk.open, bytes.data(), size, nullptr, &again, &desk.error), PENPOSE_OK)
      << desk.error.message;
  EXPECT_EQ(desk.state(again), desk.state()) << "its curve with the known target is kept";
}

}  // namespace
}  // namespace penpose::tests
