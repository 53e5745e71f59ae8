#include "core/io/tracks/read_track.h"

#include <gtest/gtest.h>

#include "core/io/tracks/track_formats.h"
#include "tests/support/track_texts.h"

namespace penpose::io {
namespace {

using tests::bytes;
using tests::mediapipe_wide;
using tests::two_frames;

TEST(FormatOfTrack, IsNotGuessedForPointsOfAnotherNumber) {
  std::string text = "x_0,y_0";
  for (int i = 1; i < 400; ++i) text += ",x_" + std::to_string(i) + ",y_" + std::to_string(i);
  EXPECT_EQ(format_of_track(bytes(text + "\n1,2\n")), nullptr);
}

TEST(TrackFormat, IsToldByTheContent) {
  const auto told = [](const std::string& text) { return std::string(format_of_track(bytes(text))->name); };
  EXPECT_EQ(told(two_frames().text()), "openface");
  EXPECT_EQ(told(mediapipe_wide(468, true)), "mediapipe");
  EXPECT_EQ(told("frame,landmark,x,y\n"), "mediapipe");
  EXPECT_EQ(told("version: 1\nn_points: 68\n{\n"), "ibug68");
  EXPECT_EQ(told("1,2,3\n"), "ibug68");
  EXPECT_EQ(told(R"({"frames": [{"curves": {}}]})"), "curves");
  EXPECT_EQ(told("[[]]"), "mediapipe");
  EXPECT_EQ(told("Timecode,BlendShapeCount,JawOpen\n"), "arkit");
  EXPECT_EQ(format_of_track(bytes("hello, world\n")), nullptr);
}

}  // namespace
}  // namespace penpose::io
