#include <gtest/gtest.h>

#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "tests/support/track_texts.h"

namespace penpose::io {
namespace {

using tests::bytes;
using tests::text_of;

TEST(ReadArkit, TellsTheRateFromWholeSeconds) {
  for (const int fps : {24, 25, 30, 50, 60}) {
    std::string text = "Timecode,BlendShapeCount,JawOpen\n";
    for (int f = 0; f < 3 * fps; ++f)
      text += "01:02:0" + std::to_string(f / fps) + ":" + std::to_string(f % fps) + ".000,1,0.5\n";
    const auto track = read_arkit_track(bytes(text)).value();
    for (int f = 0; f < 3 * fps; ++f)
      EXPECT_NEAR(track.frames[static_cast<std::size_t>(f)].time_s, f / static_cast<double>(fps), 1e-6) << fps;
  }
}

TEST(ReadArkit, ReadsNamesTimesAndHolds) {
  const auto track = read_arkit_track(bytes("Timecode,BlendShapeCount,EyeBlinkLeft,JawOpen\n"
                                            "23:59:59:59.5,61,0.1,0.2\n00:00:00:00.5,61,0.3,0.4\n"
                                            "00:00:00:01.5,0\n00:00:00:02.5,61,nan,0\n"))
                         .value();
  EXPECT_EQ(track.names, (std::vector<std::string>{"EyeBlinkLeft", "JawOpen"}));
  ASSERT_EQ(track.frames.size(), 4U);
  EXPECT_NEAR(track.frames[1].time_s, 1.0 / 60, 1e-9);
  EXPECT_DOUBLE_EQ(track.frames[1].values[1], 0.4);
  EXPECT_FALSE(track.frames[2].found);
  EXPECT_FALSE(track.frames[3].found);
  EXPECT_EQ(track.notes.size(), 2U);
  EXPECT_EQ(read_arkit_track(bytes("a,b\n1,2\n")).error().place, "line 1");
  EXPECT_EQ(read_arkit_track(bytes("Timecode,JawOpen\n0:0:0:1,x\n")).error().place, "line 2");
  EXPECT_EQ(read_arkit_track(bytes("Timecode,JawOpen\n0:0:0:1,0,5,1,2\n")).error().place, "line 2");
}

TEST(ReadArkit, SaysWhichRateItTookWhereTheTimecodesDoNotTell) {
  std::string take = "Timecode,JawOpen\n";
  for (int f = 0; f < 10; ++f) take += "0:0:0:" + std::to_string(f) + ",0.5\n";
  const auto track = read_arkit_track(bytes(take)).value();
  EXPECT_NEAR(track.frames[9].time_s, 9 / 60.0, 1e-9);
  EXPECT_NE(track.rate_note.find("60.00 frames a second"), std::string::npos) << track.rate_note;
  EXPECT_NE(track.rate_note.find("--stretch"), std::string::npos);
  const auto bare = read_arkit_track(bytes("Timecode,JawOpen\nx,0\ny,1\n")).value();
  EXPECT_NEAR(bare.frames[1].time_s, 1 / 60.0, 1e-9);
  EXPECT_NE(bare.rate_note.find("no timecode"), std::string::npos);
}

/// A take at 60 frames a second of the frames [first, end), frame numbers from 0.
std::string arkit_rows(int first, int end) {
  std::string rows;
  for (int f = first; f < end; ++f)
    rows += "0:0:" + std::to_string(f / 60) + ":" + std::to_string(f % 60) + ".5," + text_of(0.01 * f) + "\n";
  return rows;
}

TEST(ReadArkit, OfRepeatedTimecodesTheLastCountsAndRowsThatStepBackAreHeld) {
  const auto track = read_arkit_track(bytes("Timecode,JawOpen\n0:0:0:55,0\n0:0:0:56,0.1\n0:0:0:56,0.2\n0:0:0:58,0.3\n"
                                            "0:0:0:59,0.4\n0:0:0:12,0.5\n0:0:1:01,0.6\n?,0.7\n0:0:1:03,0.8\n"))
                         .value();
  const std::vector<int> numbers{0, 1, 3, 4, 5, 6, 7, 8};
  ASSERT_EQ(track.frames.size(), numbers.size());
  for (std::size_t f = 0; f < numbers.size(); ++f) {
    EXPECT_NEAR(track.frames[f].time_s, numbers[f] / 60.0, 1e-9) << f;
    EXPECT_EQ(track.frames[f].found, f != 4) << f;
  }
  EXPECT_EQ(track.frames[1].values[0], 0.2);
  ASSERT_EQ(track.notes.size(), 3U);
  EXPECT_TRUE(track.notes[0].starts_with("1 row repeats the time of the one before, the first in line 4"))
      << track.notes[0];
  EXPECT_TRUE(track.notes[1].starts_with("line 9: its timecode cannot be read")) << track.notes[1];
  EXPECT_TRUE(track.notes[2].starts_with("line 7: "));
  EXPECT_TRUE(track.rate_note.empty());
}

/// Every tenth row comes twice and every seventh is missing: the rate stays, and what is there keeps its time.
TEST(ReadArkit, RepeatedAndDroppedRowsDoNotSpoilTheRate) {
  std::string take = "Timecode,JawOpen\n";
  for (int f = 0; f < 120; ++f) {
    if (f % 7 == 6) continue;
    if (f % 10 == 3) take += arkit_rows(f, f + 1);
    take += arkit_rows(f, f + 1);
  }
  const auto track = read_arkit_track(bytes(take)).value();
  ASSERT_EQ(track.frames.size(), 120U);
  for (std::size_t f = 0; f < 120; ++f) {
    EXPECT_NEAR(track.frames[f].time_s, static_cast<double>(f) / 60, 1e-9) << f;
    EXPECT_EQ(track.frames[f].found, f % 7 != 6) << f;
    const double value = track.frames[f].found ? track.frames[f].values[0] : 0.01 * static_cast<double>(f);
    EXPECT_NEAR(value, 0.01 * static_cast<double>(f), 1e-9);
  }
}

TEST(ReadArkit, OfColumnsOfOneNameTheFirstCounts) {
  const auto track = read_arkit_track(bytes("Timecode,JawOpen,jawopen,Other\n0:0:0:0,0.25,0.5,1\n")).value();
  EXPECT_EQ(track.names, (std::vector<std::string>{"JawOpen", "Other"}));
  EXPECT_EQ(track.frames[0].values, (std::vector<double>{0.25, 1}));
  ASSERT_EQ(track.notes.size(), 1U);
  EXPECT_TRUE(track.notes[0].starts_with("line 1: the column jawopen comes again")) << track.notes[0];
}

TEST(ReadArkit, HoldsFramesThatAreLeftOut) {
  const auto track = read_arkit_track(bytes("Timecode,JawOpen\n" + arkit_rows(0, 21) + arkit_rows(51, 90))).value();
  ASSERT_EQ(track.frames.size(), 90U);
  for (std::size_t f = 0; f < 90; ++f) {
    EXPECT_EQ(track.frames[f].found, f < 21 || f >= 51) << f;
    EXPECT_NEAR(track.frames[f].time_s, static_cast<double>(f) / 60, 1e-9) << f;
  }
  EXPECT_NEAR(track.frames[51].values[0], 0.51, 1e-9);
  EXPECT_EQ(track.notes, (std::vector<std::string>{"line 23: 30 frames before it are left out and held"}));
}

TEST(ReadArkit, ARowThatIsLateLeavesNothingOut) {
  std::string take = "Timecode,JawOpen\n" + arkit_rows(0, 20) + "0:0:0:21.2,0.5\n" + arkit_rows(21, 70);
  const auto track = read_arkit_track(bytes(take)).value();
  EXPECT_EQ(track.frames.size(), 70U);
  EXPECT_TRUE(track.notes.empty());
}

TEST(ReadArkit, RowsWithoutACommonStepComeAsTheyPlease) {
  std::string take = "Timecode,JawOpen\n";
  for (int f = 0; f < 60; ++f)
    if (f % 3 != 2) take += arkit_rows(f, f + 1);
  EXPECT_EQ(read_arkit_track(bytes(take)).value().frames.size(), 40U);
  // 45 of 60 that are counted.
  take = "Timecode,JawOpen\n";
  for (int f = 0; f < 120; ++f)
    if (f % 4 != 3) take += arkit_rows(f, f + 1);
  EXPECT_EQ(read_arkit_track(bytes(take)).value().frames.size(), 90U);
}

TEST(ReadArkit, ATimecodeThatLeapsAwayIsNotGoneBy) {
  const auto track = read_arkit_track(bytes("Timecode,JawOpen\n" + arkit_rows(0, 90) + "9:0:0:0,0.5\n")).value();
  ASSERT_EQ(track.frames.size(), 91U);
  EXPECT_NEAR(track.frames[90].time_s, 1.5, 1e-6);
  EXPECT_TRUE(track.rate_note.starts_with("the timecode leaps by far in line 92: 60.00 frames")) << track.rate_note;
  // Timecodes that show no step cannot leap.
  const auto far = read_arkit_track(bytes("Timecode,JawOpen\n0:0:0:0,0\n?,0.1\n0:0:20:0,0.2\n")).value();
  ASSERT_EQ(far.frames.size(), 3U);
  EXPECT_NEAR(far.frames[1].time_s, 10, 1e-9);
}

/// Faces seen twice as often as the timecodes count.
TEST(ReadArkit, SpreadsRowsOverTimecodesThatStandStill) {
  std::string take = "Timecode,JawOpen\n";
  for (int f = 0; f < 90; ++f)
    take += "0:0:" + std::to_string(f / 60) + ":" + std::to_string(f % 60 / 2) + "," + std::to_string(f) + "\n";
  const auto track = read_arkit_track(bytes(take)).value();
  EXPECT_NEAR(track.frames[89].time_s, 89 / 60.0, 0.02);
  EXPECT_TRUE(track.frames[1].found);
  EXPECT_NE(track.rate_note.find("do not grow"), std::string::npos);
}

}  // namespace
}  // namespace penpose::io
