#include <gtest/gtest.h>

#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "tests/support/track_texts.h"

namespace penpose::io {
namespace {

using tests::bytes;

TEST(ReadCurveTrack, ReadsNamedCurves) {
  const auto track = read_curve_track(bytes(R"({"fps": 25, "frames": [
    {"curves": {"b": [[0, 0], [10, 0], [20, 0]], "a": [[1, 1], [2, 2]]}},
    {"curves": {"a": [[1, 1], [2, 3]], "b": [[0, 0], [20, 0]]}, "confidence": 0.5},
    null,
    {"curves": {"a": [[1, 1], null], "b": [[0, 0], [20, 0]]}}]})"))
                         .value();
  ASSERT_EQ(track.frames.size(), 4U);
  ASSERT_EQ(track.groups.size(), 2U);
  EXPECT_EQ(track.groups[0].name, "a");
  EXPECT_EQ(track.groups[1].first, 2U);
  EXPECT_EQ(track.frames[1].points[3], (animation::PxPoint{10, 0}));  // resampled to three points
  EXPECT_DOUBLE_EQ(track.frames[1].time_s, 0.04);
  EXPECT_FALSE(track.frames[2].found());
  EXPECT_FALSE(track.frames[3].found());
}

TEST(ReadCurveTrack, SaysWhereItIsWrong) {
  const auto place = [](const char* text) { return read_curve_track(bytes(text)).error().place; };
  EXPECT_EQ(place("[]"), "/frames");
  EXPECT_EQ(place(R"({"fps": 0, "frames": []})"), "/fps");
  EXPECT_EQ(place(R"({"frames": [{"curves": {"a": [[1, 1]]}}]})"), "/frames/0/curves/a");
  EXPECT_EQ(place(R"({"frames": [{"curves": {"a": [[1, 1], [2, "3"]]}}]})"), "/frames/0/curves/a/1");
  EXPECT_EQ(place(R"({"frames": [{"curves": {"a": [[1, 1], [2, 3]]}}, {"curves": {"b": [[1, 1], [2, 3]]}}]})"),
            "frame 0");
  EXPECT_EQ(place(R"({"frames": [{"curves": {"a": 7}}]})"), "/frames/0/curves/a");
  EXPECT_EQ(place(R"({"frames": [{"curves": {"a": [[1, 1], [2, 3]], "b": []}}, {"curves": {"b": null}}]})"),
            "/frames/0/curves/b");
}

TEST(ReadCurveTrack, HoldsFramesInWhichACurveIsMissing) {
  const auto track = read_curve_track(bytes(R"({"frames": [
    {"curves": {"a": [[0, 0], [1, 0]]}},
    {"curves": {"a": [[0, 0], [1, 0]], "b": [[5, 5], [6, 6]]}},
    {"curves": {"a": null, "b": [[5, 5], [6, 6]]}},
    {"curves": {"a": [], "b": [[5, 5], [6, 6]]}},
    {"curves": {"a": [[0, 0], [1, NaN]], "b": [[5, 5], [6, 6]]}},
    {"curves": {"a": [[0, 0]], "b": [[5, 5], [6, 6]]}},
    {"curves": {"a": [[0, 0], [1, 0]], "b": [[5, 5], [6, 6]], "bb": [[5, 5], [6, 6]]}, "confidence": NaN},
    {"curves": {"a": [[0, 0], [2, 0]], "b": [[5, 5], [6, 6]]}, "time": NaN}]})"))
                         .value();
  ASSERT_EQ(track.frames.size(), 8U);
  for (std::size_t f = 0; f < 8; ++f) EXPECT_EQ(track.frames[f].found(), f == 1 || f == 7) << f;
  EXPECT_EQ(track.frames[7].points, (std::vector<animation::PxPoint>{{0, 0}, {2, 0}, {5, 5}, {6, 6}}));
  ASSERT_EQ(track.notes.size(), 7U);
  EXPECT_TRUE(track.notes[0].starts_with("curve bb is shown by 1 of 8 frames only")) << track.notes[0];
  EXPECT_EQ(track.notes[1], "frame 0: curve b is missing; the frame is held");
  EXPECT_EQ(track.notes[3], "frame 3: curve a is empty; the frame is held");
  EXPECT_EQ(track.notes[4], "frame 4: curve a has a point that is no number; the frame is held");
}

}  // namespace
}  // namespace penpose::io
