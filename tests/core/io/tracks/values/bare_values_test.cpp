#include "core/io/tracks/values/bare_values.h"

#include <gtest/gtest.h>

#include "core/base/math.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "tests/support/track_texts.h"

namespace penpose::io {
namespace {

using tests::bytes;

animation::WeightTrack take_of(const std::string& text) {
  const TrackFormat* format = format_of_track(bytes(text));
  EXPECT_NE(format, nullptr) << text.substr(0, 200);
  EXPECT_EQ(format == nullptr ? "none" : format->name, "arkit");
  auto track = read_arkit_track(bytes(text));
  EXPECT_TRUE(track) << (track ? "" : track.error().line());
  return track ? std::move(track).value() : animation::WeightTrack();
}

/// The value of a name in a frame; -1 where there is none.
double value_in(const animation::WeightTrack& track, const std::string& name, std::size_t frame) {
  for (std::size_t i = 0; i < track.names.size(); ++i) {
    if (track.names[i] == name && track.frames.at(frame).found) return track.frames[frame].values[i];
  }
  return -1;
}

/// So many numbers, all 0 but the one at `at`.
std::string numbers(std::size_t count, std::size_t at, double value, const char* separator = ", ") {
  std::string out;
  for (std::size_t i = 0; i < count; ++i) out += (i > 0 ? separator : "") + (i == at ? tests::text_of(value) : "0");
  return out;
}

constexpr std::size_t k_jaw_left = 15, k_jaw_open = 17, k_tongue = 51;

TEST(BareValues, AzuresChunksAre60ASecondInItsOrder) {
  const auto chunk = [](int first, double value) {
    return R"({"FrameIndex": )" + std::to_string(first) + R"(, "BlendShapes": [[)" + numbers(55, k_jaw_open, value) +
           "], [" + numbers(55, k_jaw_left, value) + "]]}";
  };
  const std::string lines = chunk(0, 0.5) + "\n" + chunk(2, 0.25) + "\n";
  const std::string list = "[" + chunk(0, 0.5) + ", " + chunk(2, 0.25) + "]";
  std::string escaped = list.substr(1, list.size() - 2);
  std::string events = "[";
  for (const std::string& one : {chunk(0, 0.5), chunk(2, 0.25)}) {
    std::string text;
    for (const char c : one) text += c == '"' ? std::string("\\\"") : std::string(1, c);
    events += (events.size() > 1 ? ", " : "") + std::string(R"({"audioOffset": 0, "visemeId": 0, "animation": ")") +
              text + "\"}";
  }
  for (const std::string& text : {lines, list, events + "]"}) {
    const auto track = take_of(text);
    ASSERT_EQ(track.frames.size(), 4U) << text.substr(0, 100);
    EXPECT_EQ(track.names.size(), 55U);
    EXPECT_EQ(track.names.back(), "rightEyeRoll");
    EXPECT_EQ(value_in(track, "jawOpen", 0), 0.5);
    EXPECT_EQ(value_in(track, "jawLeft", 1), 0.5) << "Apple's order has left before right";
    EXPECT_EQ(value_in(track, "jawRight", 1), 0);
    EXPECT_EQ(value_in(track, "jawOpen", 2), 0.25);
    EXPECT_NEAR(track.frames[3].time_s, 3 / 60.0, 1e-9);
    EXPECT_TRUE(track.rate_note.empty());
    EXPECT_EQ(track.notes.size(), 1U);
  }
  // The next sentence begins at 0 again.
  EXPECT_NEAR(take_of(chunk(0, 0.5) + "\n" + chunk(0, 0.25)).frames[2].time_s, 2 / 60.0, 1e-9);
  const auto wrong = read_arkit_track(bytes(R"({"FrameIndex": 0, "BlendShapes": [[1, 2, 3]]})"));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().place, "/BlendShapes/0");
}

TEST(BareValues, TablesAndListsWithoutNamesAreArkitsInApplesOrder) {
  for (const std::size_t count : {std::size_t{51}, std::size_t{52}, std::size_t{55}, std::size_t{61}}) {
    for (const char* separator : {",", ";", "\t", " "}) {
      const auto track = take_of(numbers(count, k_jaw_open, 0.5, separator) + "\n" +
                                 numbers(count, k_jaw_left, 0.25, separator) + "\n");
      ASSERT_EQ(track.frames.size(), 2U);
      EXPECT_EQ(track.names.size(), count);
      EXPECT_EQ(value_in(track, "jawOpen", 0), 0.5);
      EXPECT_EQ(value_in(track, "jawLeft", 1), 0.25);
      ASSERT_FALSE(track.notes.empty());
      EXPECT_NE(track.notes[0].find("Apple's order"), std::string::npos);
    }
    const auto list =
        take_of("[[" + numbers(count, k_jaw_open, 0.5) + "], [" + numbers(count, k_jaw_left, 0.25) + "]]");
    EXPECT_EQ(value_in(list, "jawOpen", 0), 0.5);
    EXPECT_EQ(value_in(list, "jawLeft", 1), 0.25);
  }
  const auto frames =
      take_of(R"({"fps": 50, "frames": [[)" + numbers(52, k_tongue, 0.5) + "], [" + numbers(52, k_tongue, 1) + "]]}");
  EXPECT_EQ(value_in(frames, "tongueOut", 1), 1);
  EXPECT_NEAR(frames.frames[1].time_s, 0.02, 1e-9);
}

TEST(BareValues, AColumnThatGrowsBeforeThemIsTheirTime) {
  std::string text;
  for (int f = 0; f < 10; ++f) text += tests::text_of(0.04 * f) + "," + numbers(52, k_jaw_open, 0.1 * f, ",") + "\n";
  const auto track = take_of(text);
  EXPECT_EQ(track.names.size(), 52U);
  EXPECT_NEAR(track.frames[9].time_s, 0.36, 1e-9);
  EXPECT_NEAR(value_in(track, "jawOpen", 9), 0.9, 1e-9);
  EXPECT_EQ(bare_table("1,2,3\n4,5,6\n").count, 0U);
  EXPECT_EQ(bare_table(numbers(136, 0, 1, ",")).count, 0U) << "points of a face";
}

TEST(BareValues, CellsWithoutAValueKeepTheOneBefore) {
  for (const std::string hole : {"None", "null", "NA", "-", ""}) {
    const auto track = take_of("frame,jawOpen,eyeBlinkLeft,mouthPucker\n0,0.5,0.25,0\n1," + hole + ",0.5," + hole +
                               "\n2,0.75,0.75,0\n3," + hole + "," + hole + "," + hole + "\n");
    ASSERT_EQ(track.frames.size(), 4U) << hole;
    ASSERT_TRUE(track.frames[1].found) << hole;
    EXPECT_EQ(track.frames[1].values, (std::vector<double>{0.5, 0.5, 0})) << hole;
    EXPECT_EQ(track.frames[2].values[0], 0.75);
    EXPECT_FALSE(track.frames[3].found) << "no value at all is no face";
    ASSERT_FALSE(track.notes.empty());
    EXPECT_EQ(track.notes[0], "2 cells have no value: the one before stays");
  }
  const auto json = take_of(R"([{"blendShapes": {"jawOpen": 0.5, "mouthPucker": 0.25}},
                               {"blendShapes": {"jawOpen": null, "mouthPucker": 0.5}}])");
  EXPECT_EQ(json.frames[1].values, (std::vector<double>{0.5, 0.5}));
}

TEST(BareValues, PacketsOfIFacialMocapArePercentAndDegrees) {
  const std::string head = "|=head#-20,10,30,0.1,0.2,0.3|rightEye#5,19,1.5|leftEye#5,15,1.5|";
  for (const char* sign : {"-", "&"}) {
    const auto part = [&](const char* name, int value) { return std::string(name) + sign + std::to_string(value); };
    const auto packet = [&](int jaw, int seen) {
      return part("trackingStatus", seen) + "|" + part("jawOpen", jaw) + "|" + part("mouthSmile_L", 86) + "|" +
             part("hapihapi", 0) + head;
    };
    const auto track = take_of(packet(50, 1) + "\n" + packet(54, 0) + "\n" + packet(58, 1) + "\n");
    ASSERT_EQ(track.frames.size(), 3U);
    EXPECT_EQ(value_in(track, "jawOpen", 0), 0.5);
    EXPECT_EQ(value_in(track, "mouthSmile_L", 0), 0.86);
    EXPECT_NEAR(value_in(track, "HeadPitch", 0), base::radians(-20), 1e-12);
    EXPECT_NEAR(value_in(track, "HeadYaw", 0), base::radians(10), 1e-12);
    EXPECT_NEAR(value_in(track, "LeftEyeYaw", 0), base::radians(15), 1e-12);
    EXPECT_EQ(value_in(track, "hapihapi", 0), -1) << "no shape";
    EXPECT_FALSE(track.frames[1].found);
    EXPECT_NEAR(track.frames[2].time_s, 2 / 60.0, 1e-9);
    EXPECT_NE(track.rate_note.find("60.00"), std::string::npos);
    const auto timed = take_of("0.5 " + packet(50, 1) + "\n0.75 " + packet(60, 1) + "\n1.0 " + packet(70, 1) + "\n");
    EXPECT_NEAR(timed.frames[2].time_s, 0.5, 1e-9);
    EXPECT_EQ(value_in(timed, "jawOpen", 2), 0.7);
  }
}

TEST(BareValues, DumpsOfVmcAreTextOrJson) {
  const std::string lines =
      "/VMC/Ext/OK 1\n/VMC/Ext/T 0.5\n/VMC/Ext/Bone/Pos Head 0 0 0 0 0 0 1\n/VMC/Ext/Blend/Val jawOpen 0.5\n"
      "/VMC/Ext/Blend/Val \"Blink L\" 1\n/VMC/Ext/Blend/Apply\n/VMC/Ext/T 0.75\n/VMC/Ext/Blend/Val jawOpen 0.25\n"
      "/VMC/Ext/Blend/Apply\n/VMC/Ext/T 1.0\n/VMC/Ext/Blend/Val jawOpen 0\n/VMC/Ext/Blend/Apply\n";
  const std::string json =
      R"([{"time": 3.5, "address": "/VMC/Ext/Blend/Val", "args": ["jawOpen", 0.5]},
          {"time": 3.5, "address": "/VMC/Ext/Blend/Val", "args": [{"type": "s", "value": "Blink L"}, {"type": "f", "value": 1}]},
          {"time": 3.5, "address": "/VMC/Ext/Blend/Apply", "args": []},
          {"time": 3.75, "address": "/VMC/Ext/Blend/Val", "args": ["jawOpen", 0.25]},
          {"time": 3.75, "address": "/VMC/Ext/Blend/Apply", "args": []},
          {"time": 4.0, "address": "/VMC/Ext/Blend/Val", "args": ["jawOpen", 0]},
          {"time": 4.0, "address": "/VMC/Ext/Blend/Apply", "args": []}])";
  const std::string stamped =
      "10.5 /VMC/Ext/Blend/Val ,sf 'jawOpen' 0.5\n10.5 /VMC/Ext/Blend/Val ,sf 'Blink L' 1.0\n10.5 /VMC/Ext/Blend/Apply "
      ",\n"
      "10.75 /VMC/Ext/Blend/Val ,sf 'jawOpen' 0.25\n10.75 /VMC/Ext/Blend/Apply ,\n"
      "11.0 /VMC/Ext/Blend/Val ,sf 'jawOpen' 0.0\n11.0 /VMC/Ext/Blend/Apply ,\n";
  for (const std::string& text : {lines, json, stamped}) {
    const auto track = take_of(text);
    ASSERT_EQ(track.frames.size(), 3U) << text;
    EXPECT_EQ(track.names, (std::vector<std::string>{"jawOpen", "Blink L"}));
    EXPECT_EQ(track.frames[0].values, (std::vector<double>{0.5, 1}));
    EXPECT_EQ(track.frames[1].values, (std::vector<double>{0.25, 1})) << "what is not sent again stays";
    EXPECT_NEAR(track.frames[2].time_s, 0.5, 1e-9) << text;
  }
  EXPECT_FALSE(read_arkit_track(bytes("/VMC/Ext/Blend/Apply\n")));
}

}  // namespace
}  // namespace penpose::io
