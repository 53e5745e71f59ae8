#include <gtest/gtest.h>

#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "tests/support/track_texts.h"

namespace penpose::io {
namespace {

using tests::bytes;

animation::WeightTrack values_of(const std::string& text) {
  auto track = read_arkit_track(bytes(text));
  EXPECT_TRUE(track) << track.error().line();
  return track ? std::move(track).value() : animation::WeightTrack();
}

std::string format_of(const std::string& text) {
  const TrackFormat* format = format_of_track(bytes(text));
  return format == nullptr ? "none" : std::string(format->name);
}

TEST(ReadValues, DropFrameTimecodesLeaveNoFrameOut) {
  for (const std::string sign : {";", "."}) {
    std::string text = "Timecode,JawOpen\n";
    int number = 1790;  // 00:00:59;20
    for (int f = 0; f < 60; ++f, ++number) {
      const int shown = number + (number >= 1800 ? 2 : 0);
      text += "00:0" + std::to_string(shown / 1800) + ":" + std::to_string(shown / 30 % 60) + sign +
              std::to_string(shown % 30) + ",0.5\n";
    }
    const auto track = values_of(text);
    ASSERT_EQ(track.frames.size(), 60U) << sign;
    EXPECT_TRUE(track.notes.empty()) << sign;
    for (std::size_t f = 0; f < 60; ++f) {
      EXPECT_TRUE(track.frames[f].found);
      EXPECT_NEAR(track.frames[f].time_s, static_cast<double>(f) * 1001 / 30000, 1e-9) << sign << f;
    }
  }
}

TEST(ReadValues, SecondsMillisecondsAndCountsOfFramesAreTimes) {
  const auto last_of = [](const std::string& head, double step, int decimals) {
    std::string text = head + ",EyeBlinkLeft,JawOpen,MouthPucker\n";
    for (int f = 0; f < 31; ++f) {
      std::string time = std::to_string(f * step);
      time.resize(time.find('.') + (decimals > 0 ? 1 + static_cast<std::size_t>(decimals) : 0));
      text += time + ",0,0.5,0\n";
    }
    return values_of(text).frames.back().time_s;
  };
  EXPECT_NEAR(last_of("timecode", 1 / 30.0, 6), 1, 1e-5);
  EXPECT_NEAR(last_of("timestamp", 1 / 30.0, 6), 1, 1e-5);
  EXPECT_NEAR(last_of("timestamp_ms", 40, 0), 1.2, 1e-9);
  EXPECT_NEAR(last_of("Timecode", 1, 0), 0.5, 1e-9) << "frames of Live Link Face, 60 a second";
  EXPECT_NEAR(last_of("frame", 1, 0), 1, 1e-9) << "frames of other trackers, 30 a second";
}

TEST(ReadValues, ATableWithoutTimesIsTakenAt30WithAWord) {
  const auto track = values_of("eyeBlinkLeft,jawOpen,mouthPucker,_neutral\n0,0.1,0,1\n0,0.2,0,1\n0,0.3,0,1\n");
  EXPECT_EQ(track.names, (std::vector<std::string>{"eyeBlinkLeft", "jawOpen", "mouthPucker"}));
  EXPECT_NEAR(track.frames[2].time_s, 2 / 30.0, 1e-9);
  EXPECT_NE(track.rate_note.find("30.00 frames a second"), std::string::npos) << track.rate_note;
}

TEST(ReadValues, FramesThatACounterSkipsAreHeld) {
  std::string text = "frame,jawOpen,eyeBlinkLeft,mouthPucker\n";
  for (const int f : {0, 1, 2, 3, 4, 5, 9, 10, 11, 12}) text += std::to_string(f) + ",0.5,0,0\n";
  const auto track = values_of(text);
  ASSERT_EQ(track.frames.size(), 13U);
  EXPECT_FALSE(track.frames[7].found);
  EXPECT_TRUE(track.frames[9].found);
}

TEST(ReadValues, DecimalCommasAreTaken) {
  const auto semicolons =
      values_of("Timecode;BlendShapeCount;JawOpen;TongueOut\n00:00:00:01,5;2;0,25;0,5\n00:00:00:02,5;2;0,5;1\n");
  EXPECT_EQ(semicolons.frames[0].values, (std::vector<double>{0.25, 0.5}));
  const auto commas =
      values_of("Timecode,BlendShapeCount,JawOpen,TongueOut\n00:00:00:01,2,0,25,0,5\n00:00:00:02,2,0,5,1,0\n");
  EXPECT_EQ(commas.frames[0].values, (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(commas.frames[1].values, (std::vector<double>{0.5, 1}));
  // A timecode with ";" between semicolons.
  const auto cut = values_of("Timecode;JawOpen;TongueOut\n00:00:58;20;0,25;0\n00:00:58;21;0,5;0\n");
  EXPECT_EQ(cut.frames[1].values, (std::vector<double>{0.5, 0}));
  EXPECT_NEAR(cut.frames[1].time_s, 1001 / 30000.0, 1e-9);
}

TEST(ReadValues, PrefixesOfColumnsAreNoPartOfTheName) {
  const auto track = values_of(
      ",timeCode,blendShapes.EyeBlinkLeft,blendShapes.JawOpen,blendShapes.Custom\n"
      "0,0.0,0.1,0.5,1\n1,0.033333,0.2,0.6,1\n2,0.066667,0.2,0.6,1\n");
  EXPECT_EQ(track.names, (std::vector<std::string>{"EyeBlinkLeft", "JawOpen", "Custom"}));
  EXPECT_NEAR(track.frames[2].time_s, 2 / 30.0, 1e-5);
}

TEST(ReadValues, ARowAScoreIsTaken) {
  const std::string text =
      "frame,categoryName,score\n0,_neutral,0.1\n0,jawOpen,0.5\n0,eyeBlinkLeft,0.25\n1,jawOpen,0.75\n";
  EXPECT_EQ(format_of(text), "arkit");
  const auto track = values_of(text);
  EXPECT_EQ(track.names, (std::vector<std::string>{"jawOpen", "eyeBlinkLeft"}));
  EXPECT_EQ(track.frames[0].values, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(track.frames[1].values, (std::vector<double>{0.75, 0}));
}

TEST(ReadValues, ReadsTheTasksOfMediaPipe) {
  const std::string web =
      R"([{"timestamp": 0, "faceLandmarks": [], "faceBlendshapes": [{"categories": [
         {"index": 0, "score": 0.5, "categoryName": "_neutral"}, {"index": 1, "score": 0.25, "categoryName": "jawOpen"}]}]},
        {"timestamp": 40, "faceBlendshapes": [{"categories": [{"score": 0.5, "categoryName": "jawOpen"}]}]},
        {"timestamp": 80, "faceBlendshapes": []},
        {"timestamp": 120, "faceBlendshapes": [{"categories": [{"score": 1, "categoryName": "jawOpen"}]}]}])";
  const std::string python =
      R"({"frames": [{"time": 0, "face_blendshapes": [[{"category_name": "jawOpen", "score": 0.25}]]},
                     {"time": 0.04, "face_blendshapes": [[{"category_name": "jawOpen", "score": 0.5}]]},
                     {"time": 0.08, "face_blendshapes": []},
                     {"time": 0.12, "face_blendshapes": [[{"category_name": "jawOpen", "score": 1}]]}]})";
  for (const std::string& text : {web, python}) {
    EXPECT_EQ(format_of(text), "arkit");
    const auto track = values_of(text);
    EXPECT_EQ(track.names, std::vector<std::string>{"jawOpen"});
    ASSERT_EQ(track.frames.size(), 4U);
    EXPECT_EQ(track.frames[0].values, std::vector<double>{0.25});
    EXPECT_FALSE(track.frames[2].found);
    EXPECT_NEAR(track.frames[3].time_s, 0.12, 1e-9);
  }
  // The map of MediaPipe's points reads its scores too, where there are no points.
  const auto named = read_track(bytes(web), track_format_named("mediapipe"), {});
  ASSERT_TRUE(named) << named.error().line();
  EXPECT_TRUE(std::holds_alternative<animation::WeightTrack>(named->track));
}

TEST(ReadValues, ReadsAudio2Face) {
  const std::string omniverse = R"({"exportFps": 25, "trackPath": "a.wav", "numPoses": 2, "numFrames": 3,
      "facsNames": ["eyeBlinkL", "jawOpen"], "weightMat": [[0, 0.25], [0.5, 0.5], [1, 1]], "joints": ["jaw"]})";
  EXPECT_EQ(format_of(omniverse), "arkit");
  const auto track = values_of(omniverse);
  EXPECT_EQ(track.names, (std::vector<std::string>{"eyeBlinkL", "jawOpen"}));
  EXPECT_EQ(track.frames[1].values, (std::vector<double>{0.5, 0.5}));
  EXPECT_NEAR(track.frames[2].time_s, 2 / 25.0, 1e-9);
  EXPECT_TRUE(track.rate_note.empty()) << track.rate_note;
  const auto service = values_of(R"([{"skelAnimationHeader": {"blendShapes": ["JawOpen", "TongueOut"]}},
      {"skelAnimation": {"blendShapeWeights": [{"timeCode": 0, "values": [0.25, 0]}, {"timeCode": 0.04, "values": [0.5, 0]}]}},
      {"skelAnimation": {"blendShapeWeights": [{"timeCode": 0.08, "values": [1, 1]}]}}])");
  EXPECT_EQ(service.names, (std::vector<std::string>{"JawOpen", "TongueOut"}));
  ASSERT_EQ(service.frames.size(), 3U);
  EXPECT_EQ(service.frames[2].values, (std::vector<double>{1, 1}));
  EXPECT_NEAR(service.frames[2].time_s, 0.08, 1e-9);
  const auto by_name = values_of(R"({"fps": 50, "blendshapes": {"jawOpen": [0, 0.5, 1], "eyeBlinkLeft": [1, 0, 0]}})");
  ASSERT_EQ(by_name.frames.size(), 3U);
  EXPECT_NEAR(by_name.frames[2].time_s, 0.04, 1e-9);
}

TEST(ReadValues, ScoresMayBeWrappedAndFramesNumbered) {
  // What a page that listens to MediaPipe keeps, with its faces as lists of categories.
  const auto page = values_of(R"([
      {"timestamp": 1000, "results": {"faceLandmarks": [[{"x": 0, "y": 0, "z": 0}]],
                                      "faceBlendshapes": [[{"score": 0.25, "categoryName": "jawOpen"}]]}},
      {"timestamp": 1040, "results": {"faceLandmarks": [], "faceBlendshapes": []}},
      {"timestamp": 1080, "results": {"faceBlendshapes": [[{"score": 0.75, "categoryName": "jawOpen"}]]}}])");
  EXPECT_EQ(page.names, std::vector<std::string>{"jawOpen"});
  ASSERT_EQ(page.frames.size(), 3U);
  EXPECT_EQ(page.frames[0].values, std::vector<double>{0.25});
  EXPECT_FALSE(page.frames[1].found);
  EXPECT_NEAR(page.frames[2].time_s - page.frames[0].time_s, 0.08, 1e-9);
  // Audio2Face's stream to game engines, written to a file frame by frame.
  std::string stream = "{";
  for (const int f : {0, 2, 10, 1}) {
    stream += (stream.size() > 1 ? ", \"" : "\"") + std::to_string(f) +
              R"(": {"Audio2Face": {"Facial": {"Names": ["JawOpen", "TongueOut"], "Weights": [)" +
              std::to_string(f * 0.0625) + ", 0]}}}";
  }
  const auto engine = values_of(stream + "}");
  EXPECT_EQ(engine.names, (std::vector<std::string>{"JawOpen", "TongueOut"}));
  ASSERT_EQ(engine.frames.size(), 4U);
  for (const std::size_t f : {0U, 1U, 2U}) EXPECT_EQ(engine.frames[f].values[0], static_cast<double>(f) * 0.0625);
  EXPECT_EQ(engine.frames[3].values[0], 0.625);
}

TEST(ReadValues, WrongJsonIsSaidWithItsPlace) {
  const auto place = [](const std::string& text) { return read_arkit_track(bytes(text)).error().place; };
  EXPECT_EQ(place(R"({"facsNames": ["a", "b"], "weightMat": [[0]]})"), "/weightMat/0");
  EXPECT_EQ(place(R"([{"blendShapes": {"jawOpen": "wide"}}])"), "/0/blendShapes/jawOpen");
  EXPECT_FALSE(read_arkit_track(bytes(R"([{"faceBlendshapes": []}])")));
  EXPECT_FALSE(read_arkit_track(bytes("{}")));
}

TEST(ReadValues, AFormatThatIsNotKnownIsToldWhatIsTaken) {
  for (const std::string text : {"hello, world\n1, 2\n", R"({"bones": {"Hips": 1}})"}) {
    const auto read = read_track(bytes(text), nullptr, {});
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().remedy.find("Audio2Face"), std::string::npos) << read.error().line();
    EXPECT_NE(read.error().remedy.find(".vmd"), std::string::npos);
  }
}

}  // namespace
}  // namespace penpose::io
