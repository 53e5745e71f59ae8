#include "core/io/tracks/track_rows.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/io/tracks/read_track.h"

namespace penpose::io {
namespace {

/// Rows of one point on lines 2, 3, ...; a negative number or time is one that the file lacks.
std::vector<TrackRow> rows_of(const std::vector<int>& frames, const std::vector<double>& times) {
  std::vector<TrackRow> rows;
  for (std::size_t i = 0; i < std::max(frames.size(), times.size()); ++i) {
    TrackRow row;
    row.line = i + 2;
    if (!frames.empty()) row.frame = frames[i];
    if (!times.empty()) row.time_s = times[i];
    row.points = {{static_cast<double>(i), 0}};
    rows.push_back(row);
  }
  return rows;
}

bool says(const std::vector<std::string>& notes, const std::string& begin) {
  return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) { return note.starts_with(begin); });
}

std::vector<double> times_of(const animation::PointTrack& track) {
  std::vector<double> times;
  for (const auto& frame : track.frames) times.push_back(frame.time_s);
  return times;
}

TEST(TrackRows, ARowWhoseNumberComesAgainIsSkipped) {
  const auto track = make_track(rows_of({1, 2, 2, 3, 1, 4}, {}), 1, 25).value();
  ASSERT_EQ(track.frames.size(), 4U);
  EXPECT_EQ(track.frames[2].points[0].x, 3);
  EXPECT_DOUBLE_EQ(track.frames[3].time_s, 3 / 25.0);
  EXPECT_TRUE(says(track.notes, "line 4: frame 2 comes again")) << track.notes[0];
  EXPECT_TRUE(says(track.notes, "line 6: frame 1 "));
  EXPECT_EQ(track.notes.size(), 2U);
}

TEST(TrackRows, ATimeThatStandsStillIsPlacedByItsNumberOrHeld) {
  const std::vector<double> times{0, 0.5, 0.5, 1.5, 2.0, 1.0, 3.0};
  const auto numbered = make_track(rows_of({1, 2, 3, 4, 5, 6, 7}, times), 1, 25).value();
  EXPECT_EQ(times_of(numbered), (std::vector<double>{0, 0.5, 1, 1.5, 2, 2.5, 3}));
  EXPECT_TRUE(numbered.frames[2].found());
  EXPECT_TRUE(says(numbered.notes, "line 4: its time "));
  EXPECT_TRUE(says(numbered.notes, "line 7: its time "));
  const auto bare = make_track(rows_of({}, times), 1, 25).value();
  EXPECT_EQ(times_of(bare), times_of(numbered));
  EXPECT_FALSE(bare.frames[2].found());
  EXPECT_FALSE(bare.frames[5].found());
  EXPECT_TRUE(says(bare.notes, "line 4: its time does not come after the ones before; the frame is held"));
  EXPECT_EQ(bare.notes.size(), 2U);
}

TEST(TrackRows, NumbersAndTimesThatBeginAgainAreNotGoneBy) {
  const auto track = make_track(rows_of({1, 2, 3, 1, 2, 3}, {0, 1, 2, 0, 1, 2}), 1, 25).value();
  EXPECT_EQ(track.frames.size(), 6U);
  EXPECT_DOUBLE_EQ(track.frames[5].time_s, 5 / 25.0);
  EXPECT_TRUE(says(track.notes, "line 5: the frame numbers do not grow"));
  EXPECT_NE(track.rate_note.find("25.00 frames a second"), std::string::npos) << track.rate_note;
  // A column that was never filled says nothing.
  const auto empty = make_track(rows_of({0, 0, 0}, {0, 0, 0}), 1, 25).value();
  EXPECT_TRUE(empty.notes.empty());
  EXPECT_TRUE(empty.rate_note.empty());
  EXPECT_EQ(empty.frames.size(), 3U);
}

TEST(TrackRows, AMissingTimeLiesBetweenItsNeighbours) {
  auto rows = rows_of({}, {0, 1, 2, 3, 4, 5});
  rows[2].time_s.reset();
  rows[0].time_s = std::nan("");
  const auto track = make_track(rows, 1, 25).value();
  EXPECT_EQ(times_of(track), (std::vector<double>{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(track.frames[2].found());
}

TEST(TrackRows, ANumberThatLeapsAwayIsNotGoneBy) {
  std::vector<int> frames;
  std::vector<double> times;
  for (int i = 0; i < 30; ++i) {
    frames.push_back(i + 1);
    times.push_back(0.04 * i);
  }
  frames.back() = 300000;
  for (const auto& rows : {rows_of(frames, {}), rows_of(frames, times)}) {
    const auto track = make_track(rows, 1, 25).value();
    EXPECT_EQ(track.frames.size(), 30U);
    EXPECT_NEAR(track.frames[29].time_s, 29 / 25.0, 1e-9);
    ASSERT_EQ(track.notes.size(), 1U);
    EXPECT_EQ(track.notes[0], "line 31: the frame number leaps to 300000; rows are taken one after the other");
  }
  // Nor is a time that does; the others tell the rate.
  times.back() = 12000;
  const auto track = make_track(rows_of(frames, times), 1, 60).value();
  EXPECT_EQ(track.frames.size(), 30U);
  EXPECT_NEAR(track.frames[29].time_s, 29 / 25.0, 1e-9);
  EXPECT_TRUE(track.rate_note.starts_with("the time leaps by far in line 31: 25.00 frames a second"))
      << track.rate_note;
  // As much at the begin.
  frames.assign({0});
  for (int i = 0; i < 30; ++i) frames.push_back(300000 + i);
  EXPECT_EQ(make_track(rows_of(frames, {}), 1, 25).value().frames.size(), 31U);
}

TEST(TrackRows, AFaceThatIsGoneForLongIsHeld) {
  std::vector<int> frames;
  for (int i = 0; i < 30; ++i) frames.push_back(i < 15 ? i : i + 200);  // 8 s of 25 a second
  EXPECT_EQ(make_track(rows_of(frames, {}), 1, 25).value().frames.size(), 230U);
  for (int i = 15; i < 30; ++i) frames[static_cast<std::size_t>(i)] = i + 290;  // 12 s, fewer than 10 times the rows
  EXPECT_EQ(make_track(rows_of(frames, {}), 1, 25).value().frames.size(), 320U);
  // Every 30th frame of a video, and half a minute without a face.
  for (int i = 0; i < 30; ++i) frames[static_cast<std::size_t>(i)] = 30 * (i < 15 ? i : i + 30);
  EXPECT_EQ(make_track(rows_of(frames, {}), 1, 30).value().frames.size(), 30U * 59 + 1);
}

// A word of a text is a frame, and each of them is searched, smoothed and written.
TEST(TrackRows, AShortTextDoesNotStandForHours) {
  const auto with_empty_frames = [](std::size_t empty, std::size_t shown) {
    auto rows = rows_of({}, std::vector<double>(shown, 0.0));
    for (TrackRow& row : rows) row.time_s.reset();
    TrackRow nobody;
    nobody.why_held = "the frame has no curves";
    rows.insert(rows.begin() + 1, empty, nobody);
    return make_track(std::move(rows), 1, 25, RowName::frame);
  };
  EXPECT_TRUE(with_empty_frames(10000, 2));
  const auto refused = with_empty_frames(10001, 2);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("10001 are left out or empty"), std::string::npos) << refused.error().what;
  EXPECT_TRUE(with_empty_frames(10100, 600)) << "what shows more may leave out more";
  std::vector<int> numbers;
  for (int i = 0; i < 1200; ++i) numbers.push_back(i < 600 ? i : 11000 + i);
  EXPECT_FALSE(make_track(rows_of(numbers, {}), 1, 25)) << "numbers that leave out as many";
}

TEST(TrackRows, LongListsOfNotesAreCut) {
  std::vector<int> frames;
  for (int i = 0; i < 100; ++i) frames.push_back(3 * i);
  const auto track = make_track(rows_of(frames, {}), 1, 25).value();
  EXPECT_EQ(track.frames.size(), 298U);
  EXPECT_EQ(track.notes.size(), 21U);
  EXPECT_EQ(track.notes.back(), "and 79 frames more like these");
}

}  // namespace
}  // namespace penpose::io
