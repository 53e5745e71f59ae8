#include "replay/session/live_session.h"

#include <gtest/gtest.h>

#include "replay/session/session_player.h"
#include "tests/support/models/sheet_model.h"
#include "tests/support/session_script.h"

namespace penpose::replay {
namespace {

/// A session's text replayed on the sheet.
ReplayResult replayed(const std::string& text) {
  PlayerOptions options;
  options.open = [](const std::string&) {
    return base::Result<document::Document>(document::make_document(tests::sheet_model()));
  };
  auto playback = play_session(read_from(base::as_bytes(text)), options);
  EXPECT_TRUE(playback.ok()) << playback.error().line();
  return std::move(playback).value();
}

std::vector<geometry::PxPoint> across(double y, int points) {
  std::vector<geometry::PxPoint> line;
  for (int i = 0; i < points; ++i) line.push_back({350.0 + 10.0 * i, y});
  return line;
}

/// Puts the pen down and draws without lifting it.
void begin_stroke(tests::SessionScript& script, int device, std::int64_t time_us, double y) {
  for (const auto& p : across(y, 30)) {
    const auto report = virtual_pen_report({p, 0.5, true, true, false, false}, script.editor().view().viewport);
    script.live().report(device, time_us += 3000, report);
  }
}

TEST(LiveSession, AStrokeThatATabletsReturnCutsOffEndsAtTheSamePlaceInAReplay) {
  tests::SessionScript script(document::make_document(tests::sheet_model()));
  script.live().connect(1, virtual_pen_identity());
  begin_stroke(script, 0, 1000000, 350);
  script.live().connect(0, virtual_pen_identity());
  EXPECT_EQ(script.document().curves.size(), 1U) << "what was drawn is not lost";
  EXPECT_NE(script.text().find("# penpose gone 0\n"), std::string::npos);
  // Another tablet goes on before the first one speaks again.
  ASSERT_TRUE(script.perform(document::SetParameters{{{"lift", 0.25}}}).ok());
  begin_stroke(script, 1, 2000000, 600);
  ASSERT_TRUE(script.act(TabletGone{1}).ok());
  ASSERT_TRUE(script.stroke(across(500, 30)).ok());
  const ReplayResult playback = replayed(script.text());
  EXPECT_EQ(playback.differing, 0U) << (playback.divergence ? playback.divergence->line : 0);
  EXPECT_EQ(playback.checked, playback.steps);
  EXPECT_GE(playback.steps, 4U);
  EXPECT_EQ(playback.session->editor().state(), script.editor().state());
}

TEST(LiveSession, TheModelThatAStringTellsIsTheSameInAReplay) {
  // One of forty tablets with these ids; the string is that of a larger one than it is taken for without.
  decode::DeviceIdentity tablet;
  tablet.vendor = 0x256c;
  tablet.product = 0x006e;
  tablet.name = "HUION PenTablet";
  tablet.strings[201] = "HUION_T174_170519";
  tests::SessionScript script(document::make_document(tests::sheet_model()));
  script.live().connect(1, tablet);
  for (int i = 0; i < 40; ++i) {
    const auto x = static_cast<std::uint16_t>(22000 + 150 * i);
    const std::vector<std::uint8_t> report{0x08,
                                           0x81,
                                           static_cast<std::uint8_t>(x & 0xff),
                                           static_cast<std::uint8_t>(x >> 8),
                                           0x00,
                                           0x40,
                                           0xff,
                                           0x0f,
                                           0,
                                           0,
                                           0,
                                           0};
    script.live().report(1, 1000000 + 5000 * i, report);
  }
  ASSERT_TRUE(script.act(TabletGone{1}).ok());
  const decode::PenAxes* axes = script.live().session().pens().axes_of(1);
  ASSERT_NE(axes, nullptr);
  EXPECT_EQ(axes->x.maximum, 50800);
  const ReplayResult playback = replayed(script.text());
  ASSERT_NE(playback.session->pens().axes_of(1), nullptr);
  EXPECT_EQ(playback.session->pens().axes_of(1)->x.maximum, 50800);
  EXPECT_TRUE(playback.session->pens().guesses().empty());
  EXPECT_EQ(playback.differing, 0U);
  EXPECT_EQ(playback.session->editor().state(), script.editor().state());
}

TEST(LiveSession, AResizeInTheMiddleOfAStrokeReplaysTheSame) {
  tests::SessionScript script(document::make_document(tests::sheet_model()));
  begin_stroke(script, 0, 1000000, 350);
  document::View view = script.editor().view();
  view.viewport = {1500, 800};
  ASSERT_TRUE(script.act(ViewChanged{view}).ok());
  ASSERT_TRUE(script.stroke(across(300, 30)).ok());
  EXPECT_GE(script.document().curves.size(), 1U);
  const ReplayResult playback = replayed(script.text());
  EXPECT_EQ(playback.differing, 0U);
  EXPECT_EQ(playback.session->editor().state(), script.editor().state());
}

TEST(LiveSession, LinesThatAreRefusedDoNotAddUpInMemory) {
  tests::SessionScript script(document::make_document(tests::sheet_model()));
  TabletSetting wrong;
  wrong.area = {0, 0, 2, 2};
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(script.act(TabletSet{0, wrong}).ok());
  const ReplayResult playback = replayed(script.text());
  EXPECT_GE(playback.problems.size(), 1U);
  EXPECT_LE(playback.problems.size(), 20U);
}

}  // namespace
}  // namespace penpose::replay
