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

TEST(Phones, WordsLastUpToTheNextOneOrAPause) {
  const std::vector<Phone> phones{{"", 0, 0.5},     {"M", 0.5, 0.6, "my"}, {"AY", 0.6, 0.8},     {"T", 0.8, 0.9, "toe"},
                                  {"OW", 0.9, 1.2}, {"", 1.2, 1.5},        {"AH", 1.5, 1.6, "a"}};
  const std::vector<HeardWord> words{{"my", 0.5, 0.8}, {"toe", 0.8, 1.2}, {"a", 1.5, 1.6}};
  EXPECT_EQ(words_heard(phones), words);
  EXPECT_TRUE(words_heard({{"", 0, 1}, {"AA", 1, 2}}).empty()) << "by ear nobody knows them";
}

}  // namespace
}  // namespace penpose::speech
