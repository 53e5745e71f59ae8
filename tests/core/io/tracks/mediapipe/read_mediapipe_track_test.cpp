#include <gtest/gtest.h>

#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "tests/support/track_texts.h"

namespace penpose::io {
namespace {

using tests::bytes;
using tests::mediapipe_wide;
using tests::s;

TEST(ReadMediapipeCsv, ReadsRowsOfFramesInPx) {
  const auto track = read_mediapipe_csv(bytes(mediapipe_wide(478, false)), {}).value();
  EXPECT_EQ(track.point_count, 478U);
  EXPECT_EQ(track.frames[1].points[3], (animation::PxPoint{3, 103}));
  EXPECT_NEAR(track.frames[1].time_s, 0.033, 1e-9);  // milliseconds
  EXPECT_NEAR(track.frames[0].depths[5], 7, 1e-9);
}

TEST(ReadMediapipeCsv, SharesOfThePictureNeedItsSize) {
  const auto text = mediapipe_wide(468, true);
  const auto track = read_mediapipe_csv(bytes(text), PictureSize{1920, 1080}).value();
  EXPECT_EQ(track.point_count, 468U);
  EXPECT_NEAR(track.frames[0].points[100].x, 192, 1e-9);
  EXPECT_NEAR(track.frames[0].points[100].y, 216, 1e-9);
  const auto square = read_mediapipe_csv(bytes(text), {}).value();
  ASSERT_EQ(square.notes.size(), 1U);
  EXPECT_NE(square.notes[0].find("--picture"), std::string::npos);
}

TEST(ReadMediapipeCsv, ReadsRowsOfPoints) {
  std::string text = "frame,landmark,x,y,z\n";
  for (int f = 0; f < 2; ++f) {
    for (int i = 0; i < 468; ++i) {
      if (f == 1 && i == 40) continue;
      text += std::to_string(f) + "," + std::to_string(i) + "," + std::to_string(i + 3) + "," + std::to_string(2 * i) +
              ",0\n";
    }
  }
  const auto track = read_mediapipe_csv(bytes(text), {}).value();
  EXPECT_EQ(track.frames[0].points[40], (animation::PxPoint{43, 80}));
  EXPECT_FALSE(track.frames[1].found());
  EXPECT_EQ(read_mediapipe_csv(bytes("frame,landmark,x,y\n0,478,1,1\n"), {}).error().place, "line 2");
  EXPECT_EQ(read_mediapipe_csv(bytes("frame,x_0,y_0\n0,1,1\n"), {}).error().place, "line 1");
}

std::string face(int shift, int points = 468, const char* form = "object") {
  std::string text = "[";
  for (int i = 0; i < points; ++i) {
    const std::string x = std::to_string(i + shift);
    const std::string y = std::to_string(2 * i);
    if (i > 0) text += ",";
    text +=
        std::string(form) == "object" ? s(R"({"x":)") + x + R"(,"y":)" + y + R"(,"z":-1})" : s("[") + x + "," + y + "]";
  }
  return text + "]";
}

TEST(ReadMediapipeJson, ReadsTheShapesThatProgramsWrite) {
  const std::string list = s("[") + face(0) + "," + face(1) + ",null]";
  for (const std::string& text :
       {list, s(R"({"fps": 25, "frames": )") + list + "}",
        s(R"({"frames": [{"landmarks": )") + face(0) + R"(}, {"landmarks": )" + face(1) + R"(}, {"landmarks": []}]})",
        s(R"({"frames": [{"faceLandmarks": [)") + face(0) + R"(]}, {"faceLandmarks": [)" + face(1) + R"(]}, {}]})",
        s("[") + face(0, 478, "list") + "," + face(1, 478, "list") + ",[]]"}) {
    const auto track = read_mediapipe_json(bytes(text), {});
    ASSERT_TRUE(track.ok()) << track.error().line();
    ASSERT_EQ(track->frames.size(), 3U);
    EXPECT_EQ(track->frames[1].points[7], (animation::PxPoint{8, 14}));
    EXPECT_FALSE(track->frames[2].found());
  }
}

TEST(ReadMediapipeJson, TakesTimesInMilliseconds) {
  const std::string text = s(R"({"frames": [{"timestamp": 0, "landmarks": )") + face(0) +
                           R"(}, {"timestamp": 40, "landmarks": )" + face(1) + "}]}";
  EXPECT_NEAR(read_mediapipe_json(bytes(text), {}).value().frames[1].time_s, 0.04, 1e-9);
}

TEST(ReadMediapipeJson, TakesTimesOfTheDayInAnyUnit) {
  for (const char* const times : {"1700000000000,1700000000040", "1700000000000000,1700000000040000",
                                  "1700000000.00,1700000000.04", "\"0.00\",\"0.04\""}) {
    const std::string both = times;
    const auto comma = both.find(',');
    const std::string text = s(R"({"frames": [{"timestamp": )") + both.substr(0, comma) + R"(, "landmarks": )" +
                             face(0) + R"(}, {"timestamp": )" + both.substr(comma + 1) + R"(, "landmarks": )" +
                             face(1) + "}]}";
    const auto track = read_mediapipe_json(bytes(text), {}).value();
    EXPECT_NEAR(track.frames[1].time_s - track.frames[0].time_s, 0.04, 1e-3) << times;
  }
}

TEST(ReadMediapipeJson, TakesAFrameALine) {
  const std::string line = s(R"({"landmarks": )") + face(0) + "}\n";
  EXPECT_EQ(read_mediapipe_json(bytes(line + "\n" + line + "null\n"), {}).value().frames.size(), 3U);
  EXPECT_EQ(read_mediapipe_json(bytes(line + line + line.substr(0, 50)), {}).error().place, "line 3");
  EXPECT_TRUE(read_mediapipe_json(bytes("{\n\"frames\": x}"), {}).error().place.starts_with("byte offset"));
}

TEST(ReadMediapipeCsv, OnePointFarOffDoesNotMakeItPx) {
  std::string text = mediapipe_wide(468, true);
  const auto last = text.find_last_of(',');
  const auto before = text.find_last_of(',', last - 1);
  text.replace(before + 1, last - before - 1, "3.5");
  const auto track = read_mediapipe_csv(bytes(text), PictureSize{1920, 1080}).value();
  EXPECT_NEAR(track.frames[0].points[100].x, 192, 1e-9);
}

TEST(ReadMediapipeJson, FollowsOneFaceOfSeveral) {
  const std::string text = s(R"([{"faceLandmarks": [)") + face(0) + "," + face(5000) + R"(]}, {"faceLandmarks": [)" +
                           face(5001) + "," + face(1) + "]}]";
  const auto track = read_mediapipe_json(bytes(text), {}).value();
  EXPECT_EQ(track.frames[0].points[0].x, 0);
  EXPECT_EQ(track.frames[1].points[0].x, 1);
}

TEST(ReadMediapipeJson, SaysWhereItIsWrong) {
  EXPECT_EQ(
      read_mediapipe_json(bytes(s("[") + face(0, 12) + "]"), {}).error().line(),
      "frame 0: no frame shows a face: a face of 468 or 478 points was expected, not of 12; track the video again");
  EXPECT_EQ(read_mediapipe_json(bytes("{}"), {}).error().place, "/frames");
  const auto mixed = read_mediapipe_json(bytes(s("[") + face(0) + "," + face(0, 478) + "," + face(0, 5) + "]"), {});
  EXPECT_FALSE(mixed.value().frames[1].found());
  EXPECT_FALSE(mixed.value().frames[2].found());
  EXPECT_EQ(mixed.value().notes.size(), 2U);
  EXPECT_FALSE(read_mediapipe_json(bytes("[null, null]"), {}).ok());
  EXPECT_EQ(read_mediapipe_json(bytes("[1]"), {}).error().place, "frame 0 (/0)");
  const std::string odd = s(R"({"frames": [{"landmarks": )") + face(0) + R"(}, {"landmarks": [1, 2]}]})";
  EXPECT_EQ(read_mediapipe_json(bytes(odd), {}).error().place, "frame 1 (/frames/1/landmarks/0)");
  EXPECT_NE(read_mediapipe_json(bytes(R"([{"mesh": []}])"), {}).error().what.find("faceLandmarks"), std::string::npos);
}

/// One picture's result, in the shapes that programs give it.
TEST(ReadMediapipeJson, TakesASingleFace) {
  for (const std::string& text :
       {face(3), face(3, 478, "list"), s(R"({"frames": )") + face(3) + "}", s(R"({"landmarks": )") + face(3) + "}",
        s(R"({"faceLandmarks": [)") + face(3) + R"(], "faceBlendshapes": []})", s("[") + face(3) + "]",
        s(R"([{"faces": [{"keypoints": )") + face(3) + "}]}]",
        s(R"([{"multi_face_landmarks": [{"landmark": )") + face(3) + "}]}]"}) {
    const auto track = read_mediapipe_json(bytes(text), {});
    ASSERT_TRUE(track.ok()) << track.error().line() << text.substr(0, 60);
    ASSERT_EQ(track->frames.size(), 1U) << text.substr(0, 60);
    EXPECT_EQ(track->frames[0].points[7], (animation::PxPoint{10, 14})) << text.substr(0, 60);
  }
  const auto clip = read_mediapipe_json(bytes(s(R"({"face_landmarks": [)") + face(0) + "," + face(1) + "]}"), {});
  EXPECT_EQ(clip.value().frames.size(), 2U);
}

TEST(ReadMediapipeJson, HoldsFramesThatAreNoNumber) {
  std::string broken = face(1);
  broken.replace(broken.find("\"x\":1,"), 6, "\"x\":NaN,");
  const auto track = read_mediapipe_json(bytes(s("[") + face(0) + "," + broken + "," + face(2) + "]"), {}).value();
  ASSERT_EQ(track.frames.size(), 3U);
  EXPECT_FALSE(track.frames[1].found());
  EXPECT_EQ(track.frames[2].points[7], (animation::PxPoint{9, 14}));
  ASSERT_EQ(track.notes.size(), 1U);
  EXPECT_TRUE(track.notes[0].starts_with("frame 1: ")) << track.notes[0];
}

TEST(ReadMediapipeCsv, ALandmarkThatComesAgainIsNoted) {
  std::string table = "frame,landmark,x,y\n";
  for (int f = 0; f < 2; ++f) {
    for (int i = 0; i < 468; ++i)
      table += std::to_string(f) + "," + std::to_string(i) + "," + std::to_string(i) + "," + std::to_string(f) + "\n";
  }
  const auto track = read_mediapipe_csv(bytes(table + "1,5,900,900\n"), std::nullopt).value();
  EXPECT_EQ(track.frames[1].points[5], (animation::PxPoint{5, 1}));
  ASSERT_FALSE(track.notes.empty());
  EXPECT_TRUE(track.notes[0].starts_with("line 938: landmark 5 of frame 1 comes again")) << track.notes[0];
}

}  // namespace
}  // namespace penpose::io
