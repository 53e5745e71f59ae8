#include "core/phonetics/phones.h"

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

TEST(Phones, AStopThatWasHeardTakesItsTimeFromTheWords) {
  const std::vector<Phone> said{{"T", 0, 0.1, "tie"}, {"AY", 0.1, 0.4}, {"M", 0.5, 0.6, "my"}, {"AY", 0.6, 0.8}};
  const std::vector<Phone> expected{{"T", 0, 0.1, "tie"}, {"AY", 0.1, 0.2},      {"P", 0.2, 0.3, ""},
                                    {"AY", 0.3, 0.4},     {"M", 0.5, 0.6, "my"}, {"AY", 0.6, 0.8}};
  EXPECT_EQ(with_stops(said, {{"P", 0.2, 0.3}, {"P", 0.52, 0.62}, {"M", 0.65, 0.75}, {"P", 0.7, 0.74}}), expected)
      << "not one beside an m, none that is short, and no m";
  const auto first = with_stops(said, {{"P", 0, 0.12}});
  ASSERT_EQ(first.size(), 4U);
  EXPECT_EQ(first[0], (Phone{"P", 0, 0.12, "tie"})) << "the word begins with it";
  EXPECT_EQ(first[1], (Phone{"AY", 0.12, 0.4}));
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
