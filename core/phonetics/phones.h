#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"

namespace penpose::speech {

/// A phoneme of the CMU dictionary, without stress, or a pause (an empty name), and when it sounds, s.
struct Phone {
  std::string name;
  double from_s = 0;
  double to_s = 0;
  std::string word = {};  ///< that begins with it, where it is known
  friend bool operator==(const Phone&, const Phone&) = default;
};

/// The words of a text in lower case: letters of ASCII and apostrophes. Numbers are left out.
[[nodiscard]] std::vector<std::string> words_of(std::string_view text);

/// The phonemes of a text by a dictionary in CMU's form, "word P1 P2 ..." a line; the first way to say a word counts. A
/// word that is not there is spelt by rules that get its lips right rather than its vowels.
[[nodiscard]] std::vector<std::string> phonemes_of(std::string_view text, base::Bytes dictionary);

/// The same with the words that they are of.
struct SaidWord {
  std::string word;
  std::vector<std::string> phonemes;
};
[[nodiscard]] std::vector<SaidWord> said_words(std::string_view text, base::Bytes dictionary);
/// The same for words as words_of gives them, one each.
[[nodiscard]] std::vector<SaidWord> said_list(const std::vector<std::string>& words, base::Bytes dictionary);

/// A word and when it is said, s.
struct HeardWord {
  std::string word;
  double from_s = 0;
  double to_s = 0;
  friend bool operator==(const HeardWord&, const HeardWord&) = default;
};
/// The words that phonemes begin, each up to the next one or a pause.
[[nodiscard]] std::vector<HeardWord> words_heard(const std::vector<Phone>& phones);

/// What words say with the p's that were heard besides: those of `heard` that last k_least_stop_s and meet no p, b or m
/// of `said` take their time from what is there. Both are ascending.
[[nodiscard]] std::vector<Phone> with_stops(const std::vector<Phone>& said, const std::vector<Phone>& heard);
inline constexpr double k_least_stop_s = 0.06;

/// The phonemes of a word by its letters alone.
[[nodiscard]] std::vector<std::string> spelt(std::string_view word);

}  // namespace penpose::speech
