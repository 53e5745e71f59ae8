#include "core/phonetics/phone_names.h"

#include <gtest/gtest.h>

#include "core/phonetics/spoken_letters.h"
#include "core/phonetics/visemes.h"

namespace penpose::speech {
namespace {

using Names = std::vector<std::string>;

Names phonemes(const Names& labels, PhoneAlphabet alphabet) {
  Names out;
  for (const std::string& label : labels) out.push_back(phoneme_of_label(label, alphabet).value_or("?"));
  return out;
}

TEST(PhoneNames, ArpabetHasStressPlacesAndMoreOfTimit) {
  EXPECT_EQ(phonemes({"AA1", "hh_B", "ih0_I", "axr", "pcl", "sil", "xyz"}, PhoneAlphabet::arpabet),
            (Names{"AA", "HH", "IH", "ER", "P", "", "?"}));
}

TEST(PhoneNames, AnIpaLabelIsOneSound) {
  EXPECT_EQ(phonemes({"ə", "pʰ", "tʃ", "d͡ʒ", "aj", "aʊ", "iː", "ɹ", "ŋ", "β", "hello", "ma"}, PhoneAlphabet::ipa),
            (Names{"AH", "P", "T", "D", "AA", "AW", "IY", "R", "NG", "B", "?", "?"}));
}

TEST(PhoneNames, SampaKeepsItsCase) {
  EXPECT_EQ(phonemes({"@", "E", "S", "tS", "aI", "OY", "2:", "{", "mb"}, PhoneAlphabet::sampa),
            (Names{"AH", "EH", "SH", "T", "AA", "AO", "OW", "AE", "?"}));
}

TEST(PhoneNames, TheAlphabetIsThatOfMostLabels) {
  EXPECT_EQ(spelling_of({"HH", "AH0", "L", "OW1", "sil"}).alphabet, PhoneAlphabet::arpabet);
  EXPECT_EQ(spelling_of({"h", "ə", "l", "oʊ", ""}).alphabet, PhoneAlphabet::ipa);
  EXPECT_EQ(spelling_of({"h", "@", "l", "@U", "{"}).alphabet, PhoneAlphabet::sampa);
  const auto words = spelling_of({"hello", "world", "<p:>"});
  EXPECT_EQ(words.known, 0U);
  EXPECT_EQ(words.spoken, 2U);
}

TEST(SpokenLetters, EveryLanguageHasLettersOfTheDictionary) {
  EXPECT_EQ(words_spoken("Don’t stop, 42!"), (Names{"don't", "stop", "four", "two"}));
  EXPECT_EQ(words_spoken("Über Straße, été"), (Names{"uber", "strasse", "ete"}));
  EXPECT_EQ(words_spoken("привет мама"), (Names{"priv"
                                                "yet",
                                                "mama"}));
  EXPECT_EQ(words_spoken("まん カ"), (Names{"man", "ka"}));
  EXPECT_EQ(words_spoken("你好"), (Names{"tata"}));
  EXPECT_TRUE(words_spoken("♪ … \xff").empty());
}

TEST(Visemes, ServicesVisemesAreTheNineMouths) {
  EXPECT_EQ(mouth_of_polly("p"), NineMouth::closed);
  EXPECT_EQ(mouth_of_polly("O"), NineMouth::o);
  EXPECT_EQ(mouth_of_polly("sil"), NineMouth::rest);
  EXPECT_EQ(mouth_of_polly("P"), std::nullopt) << "case tells them apart";
  EXPECT_EQ(mouth_of_azure(21), NineMouth::closed);
  EXPECT_EQ(mouth_of_azure(18), NineMouth::f);
  EXPECT_EQ(mouth_of_azure(0), NineMouth::rest);
  EXPECT_EQ(mouth_of_azure(22), std::nullopt);
  EXPECT_EQ(mouth_of_oculus("viseme_PP"), NineMouth::closed);
  EXPECT_EQ(mouth_of_oculus("aa"), NineMouth::a);
  EXPECT_EQ(mouth_of_oculus("E"), std::nullopt) << "others have an E as well";
}

}  // namespace
}  // namespace penpose::speech
