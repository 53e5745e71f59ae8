#include <gtest/gtest.h>

#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "tests/support/track_texts.h"

namespace penpose::io {
namespace {

using tests::bytes;

double value_at(const animation::WeightTrack& track, const std::string& name, double time_s) {
  for (std::size_t i = 0; i < track.names.size(); ++i) {
    if (track.names[i] != name) continue;
    for (const auto& frame : track.frames) {
      if (frame.time_s >= time_s - 1e-9) return frame.values[i];
    }
  }
  return -1;
}

TEST(ReadCues, RhubarbsThreeFormatsSayTheSame) {
  const std::string tsv = "0.00\tX\n0.50\tD\n1.00\tB\n1.50\tX\n";
  const std::string json = R"({"metadata": {"soundFile": "a.wav", "duration": 2}, "mouthCues": [
      {"start": 0.00, "end": 0.50, "value": "X"}, {"start": 0.50, "end": 1.00, "value": "D"},
      {"start": 1.00, "end": 1.50, "value": "B"}, {"start": 1.50, "end": 2.00, "value": "X"}]})";
  const std::string xml =
      "<?xml version=\"1.0\"?>\n<rhubarbResult><mouthCues>\n<mouthCue start=\"0.00\" end=\"0.50\">X</mouthCue>\n"
      "<mouthCue start=\"0.50\" end=\"1.00\">D</mouthCue>\n<mouthCue start=\"1.00\" end=\"1.50\">B</mouthCue>\n"
      "<mouthCue start=\"1.50\" end=\"2.00\">X</mouthCue></mouthCues></rhubarbResult>\n";
  for (const std::string& text : {tsv, json, xml}) {
    ASSERT_NE(format_of_track(bytes(text)), nullptr) << text;
    EXPECT_EQ(format_of_track(bytes(text))->name, "cues");
    const auto track = read_cue_track(bytes(text)).value();
    EXPECT_EQ(track.names, (std::vector<std::string>{"mouth cue X", "mouth cue D", "mouth cue B"}));
    EXPECT_EQ(value_at(track, "mouth cue D", 0.7), 1);
    EXPECT_EQ(value_at(track, "mouth cue D", 1.2), 0);
    EXPECT_NEAR(value_at(track, "mouth cue B", 1.0), 0.5, 1e-9) << "one goes over into the next";
    for (const auto& frame : track.frames) {
      EXPECT_NEAR(frame.values[0] + frame.values[1] + frame.values[2], 1, 1e-9) << frame.time_s;
    }
  }
  EXPECT_NEAR(read_cue_track(bytes(json)).value().frames.back().time_s, 2, 1e-9);
}

TEST(ReadCues, PapagayosSwitchesCountFrames) {
  const std::string text = "MohoSwitch1\n1 rest\n13 MBP\n25 E\n37 rest\n";
  EXPECT_EQ(format_of_track(bytes(text))->name, "cues");
  const auto track = read_cue_track(bytes(text)).value();
  EXPECT_EQ(track.names, (std::vector<std::string>{"mouth cue rest", "mouth cue MBP", "mouth cue E."}));
  EXPECT_EQ(value_at(track, "mouth cue MBP", 0.75), 1);
  EXPECT_EQ(value_at(track, "mouth cue E.", 1.25), 1);
  EXPECT_NE(track.rate_note.find("24"), std::string::npos);
}

TEST(ReadCues, WrongCuesAreSaidWithTheirPlace) {
  const auto place = [](const std::string& text) { return read_cue_track(bytes(text)).error().place; };
  EXPECT_EQ(place("0.5\tA\n0.2\tB\n"), "line 2");
  EXPECT_EQ(place("MohoSwitch1\nx rest\n"), "line 2");
  EXPECT_EQ(place(R"({"mouthCues": [{"start": 0}]})"), "/mouthCues/0");
  EXPECT_EQ(place("MohoSwitch1\n"), "line 1");
  EXPECT_FALSE(read_cue_track(bytes("0.0\tA\n900000\tB\n"))) << "too many frames";
  EXPECT_FALSE(read_cue_track(bytes("<mouthCue start=\"0\"")));
}

}  // namespace
}  // namespace penpose::io
