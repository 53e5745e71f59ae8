#include "core/speech/cues.h"

#include <gtest/gtest.h>

#include "core/phonetics/nine_mouths.h"

namespace penpose::speech {
namespace {

Cues cues_in(std::string_view text, double moho_fps = 24) {
  auto read = read_mouth_cues(base::as_bytes(text), moho_fps);
  EXPECT_TRUE(read.ok()) << text;
  return read ? std::move(read->cues) : Cues();
}

TEST(MouthCues, RhubarbsLettersAreTheNineMouths) {
  const Cues expected{{0, "rest"}, {0.5, "closed"}, {0.75, "A"}, {1, "F"}, {1.5, "rest"}};
  EXPECT_EQ(cues_in("0.00\tX\n0.50\tA\n0.75\tD\n1.00\tG\n1.50\tX\n"), expected);
  EXPECT_EQ(cues_in(R"({"mouthCues": [{"start": 0, "end": 0.5, "value": "X"}, {"start": 0.5, "end": 0.75, "value": "A"},
      {"start": 0.75, "end": 1, "value": "D"}, {"start": 1, "end": 1.5, "value": "G"}]})"),
            expected);
  EXPECT_EQ(cues_in("<r><mouthCues><mouthCue start=\"0\" end=\"0.5\">X</mouthCue><mouthCue start=\"0.5\" end=\"0.75\">A"
                    "</mouthCue><mouthCue start=\"0.75\" end=\"1\">D</mouthCue><mouthCue start=\"1\" end=\"1.5\">G"
                    "</mouthCue></mouthCues></r>"),
            expected);
}

TEST(MouthCues, PapagayosNamesAreTheNineMouthsAtTheRateOfItsFrames) {
  const std::string_view moho = "MohoSwitch1\n1 rest\n13 MBP\n19 AI\n25 WQ\n37 etc\n";
  EXPECT_EQ(cues_in(moho), (Cues{{0, "rest"}, {0.5, "closed"}, {0.75, "A"}, {1, "U"}, {1.5, "consonants"}}));
  EXPECT_EQ(cues_in(moho, 12).at(1).time_s, 1.0);
}

TEST(MouthCues, ANameOfTheArtistsOwnStays) { EXPECT_EQ(cues_in("0.00\tX\n0.50\tgrin\n").back(), (Cue{0.5, "grin"})); }

TEST(MouthCues, WhatIsNoCueIsRefused) {
  for (const std::string_view text : {"", "hello", "1.0\tA\n0.5\tB\n", "MohoSwitch1\n", "{\"mouthCues\": 3}"})
    EXPECT_FALSE(read_mouth_cues(base::as_bytes(text)).ok()) << text;
}

TEST(PhonesAsCues, LipsAreClosedThroughTheSilenceOfAStopAndTheHumOfAnM) {
  const Cues cues = cues_of({{"", 0, 0.1},
                             {"AA", 0.1, 0.3},
                             {"", 0.3, 0.36},
                             {"P", 0.36, 0.4},
                             {"IY", 0.4, 0.6},
                             {"M", 0.6, 0.64},
                             {"", 0.64, 0.74},
                             {"AH", 0.74, 0.9}});
  EXPECT_EQ(cues, (Cues{{0, "A"}, {0.3, "closed"}, {0.4, "E"}, {0.6, "closed"}, {0.74, "A"}, {0.9, "rest"}}));
}

TEST(PhonesAsCues, TheMouthRestsInPausesAndClosesBeforeItIsHeard) {
  const Cues cues = cues_of({{"AA", 0, 0.5}, {"", 0.5, 1.5}, {"B", 1.5, 1.6}, {"AA", 1.6, 2}, {"", 2, 3}});
  ASSERT_EQ(cues.size(), 5U);
  EXPECT_EQ(cues[1], (Cue{0.5, "rest"}));
  EXPECT_EQ(cues[2].mouth, "closed");
  EXPECT_LT(cues[2].time_s, 1.5);
  EXPECT_EQ(cues[4], (Cue{2, "rest"}));
}

TEST(NineMouths, EveryPhonemeOfTheDictionaryHasOne) {
  EXPECT_EQ(mouth_of_phoneme("M"), NineMouth::closed);
  EXPECT_EQ(mouth_of_phoneme("AE1"), NineMouth::a);
  EXPECT_EQ(mouth_of_phoneme("ow2"), NineMouth::o);
  EXPECT_EQ(mouth_of_phoneme("V"), NineMouth::f);
  EXPECT_EQ(mouth_of_phoneme("nonsense"), NineMouth::rest);
}

}  // namespace
}  // namespace penpose::speech
