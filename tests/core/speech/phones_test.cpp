#include "core/speech/phones.h"

#include <gtest/gtest.h>

namespace penpose::speech {
namespace {

using Names = std::vector<std::string>;

TEST(Phones, WordsAreLettersWithoutSigns) {
  EXPECT_EQ(words_of("Don't stop, Bob -- 42!"), (Names{"don't", "stop", "bob"}));
  EXPECT_TRUE(words_of(" 1 2 ").empty());
}

TEST(Phones, TheDictionarySaysHowAWordSounds) {
  const auto dictionary = base::as_bytes("my M AY1\nlamp L AE1 M P\nlamp(2) L AA1 M P\nmy M IY\n");
  EXPECT_EQ(phonemes_of("My lamp, my", dictionary), (Names{"M", "AY", "L", "AE", "M", "P", "M", "AY"}));
}

TEST(Phones, AWordThatNobodyKnowsIsSpelt) {
  EXPECT_EQ(phonemes_of("Bamph", {}), (Names{"B", "AE", "M", "F"}));
  EXPECT_EQ(spelt("pumma"), (Names{"P", "AH", "M", "AE"}));
}

}  // namespace
}  // namespace penpose::speech
