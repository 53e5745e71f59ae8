#include "core/phonetics/spoken_letters.h"

#include <algorithm>
#include <array>

#include "core/base/text/letters.h"
#include "core/base/text/utf8.h"
#include "core/phonetics/phones.h"

namespace penpose::speech {
namespace {

constexpr std::size_t k_most_spoken = 200'000;
constexpr std::array<std::string_view, 10> k_digits{"zero", "one", "two",   "three", "four",
                                                    "five", "six", "seven", "eight", "nine"};

/// U+00C0 to U+017F without marks.
constexpr std::string_view k_latin =
    "aaaaaaeceeeeiiiidnooooo ouuuuytsaaaaaaeceeeeiiiidnooooo ouuuuytyaaaaaaccccccccddddeeeeeeeeeegggg"
    "gggghhhhiiiiiiiiiiiijjkkkllllllllllnnnnnnnnnooooooeerrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
/// U+0391 to U+03C9.
constexpr std::array<std::string_view, 25> k_greek{"a", "v", "g", "d", "e", "z", "i", "th", "i", "k", "l",  "m", "n",
                                                   "x", "o", "p", "r", "s", "s", "t", "i",  "f", "h", "ps", "o"};
/// U+0430 to U+044F.
constexpr std::array<std::string_view, 32> k_cyrillic{"a",  "b",  "v",  "g",  "d", "ye", "zh", "z", "i",  "y", "k",
                                                      "l",  "m",  "n",  "o",  "p", "r",  "s",  "t", "u",  "f", "h",
                                                      "ts", "ch", "sh", "sh", "",  "i",  "",   "e", "yu", "ya"};
/// U+3041 to U+3093; katakana lie 0x60 above.
constexpr std::array<std::string_view, 83> k_kana{
    "a",  "a",   "i",  "i",  "u",  "u",   "e",  "e",  "o",  "o",  "ka", "ga", "ki", "gi", "ku", "gu",  "ke",
    "ge", "ko",  "go", "sa", "za", "shi", "ji", "su", "zu", "se", "ze", "so", "zo", "ta", "da", "chi", "ji",
    "",   "tsu", "zu", "te", "de", "to",  "do", "na", "ni", "nu", "ne", "no", "ha", "ba", "pa", "hi",  "bi",
    "pi", "fu",  "bu", "pu", "he", "be",  "pe", "ho", "bo", "po", "ma", "mi", "mu", "me", "mo", "ya",  "ya",
    "yu", "yu",  "yo", "yo", "ra", "ri",  "ru", "re", "ro", "wa", "wa", "i",  "e",  "o",  "n"};

char32_t code_of(std::string_view sign) {
  const auto byte = [&](std::size_t i) { return static_cast<char32_t>(static_cast<unsigned char>(sign[i])); };
  if (sign.size() == 2) return (byte(0) & 0x1fU) << 6U | (byte(1) & 0x3fU);
  if (sign.size() == 3) return (byte(0) & 0x0fU) << 12U | (byte(1) & 0x3fU) << 6U | (byte(2) & 0x3fU);
  if (sign.size() == 4)
    return (byte(0) & 0x07U) << 18U | (byte(1) & 0x3fU) << 12U | (byte(2) & 0x3fU) << 6U | (byte(3) & 0x3fU);
  return sign.empty() ? 0 : byte(0);
}

bool within(char32_t code, char32_t first, char32_t last) { return code >= first && code <= last; }

/// Latin letters for one of another script; empty: it makes no sound.
std::string_view latin_of(char32_t code) {
  if (within(code, 0xc0, 0x17f) && code != 0xd7 && code != 0xf7) {
    const std::size_t at = code - 0xc0;
    return at < k_latin.size() ? k_latin.substr(at, 1) : std::string_view("s");
  }
  if (within(code, 0x1e00, 0x1eff)) {
    // Vietnamese, vowel by vowel.
    constexpr std::array<std::pair<char32_t, std::string_view>, 7> k_ends{
        {{0x1e9f, "s"}, {0x1eb7, "a"}, {0x1ec7, "e"}, {0x1ecb, "i"}, {0x1ee3, "o"}, {0x1ef1, "u"}, {0x1eff, "i"}}};
    for (const auto& [end, letter] : k_ends) {
      if (code <= end) return letter;
    }
  }
  if (code == 0x1a0 || code == 0x1a1) return "o";
  if (code == 0x1af || code == 0x1b0) return "u";
  if (within(code, 0x391, 0x3a9)) return k_greek[code - 0x391];
  if (within(code, 0x3b1, 0x3c9)) return k_greek[code - 0x3b1];
  if (within(code, 0x3ac, 0x3ce)) return code == 0x3ac ? "a" : code == 0x3ad ? "e" : code >= 0x3cc ? "o" : "i";
  if (within(code, 0x410, 0x42f)) return k_cyrillic[code - 0x410];
  if (within(code, 0x430, 0x44f)) return k_cyrillic[code - 0x430];
  if (code == 0x401 || code == 0x451) return "yo";
  if (within(code, 0x404, 0x45f)) return "i";
  if (within(code, 0x3041, 0x3093)) return k_kana[code - 0x3041];
  if (within(code, 0x30a1, 0x30f3)) return k_kana[code - 0x30a1];
  // Signs rather than letters: punctuation, arrows, dingbats, marks of vowels, pictures.
  if (code < 0x370 || within(code, 0x2000, 0x2bff) || within(code, 0x3000, 0x3040) || within(code, 0x3094, 0x30a0) ||
      within(code, 0x30f4, 0x30ff) || within(code, 0xd800, 0xf8ff) || within(code, 0xfe00, 0xff60) || code >= 0x1f000) {
    return {};
  }
  return "ta";
}

}  // namespace

std::vector<std::string> words_spoken(std::string_view text) {
  std::vector<std::string> words(1);
  const auto close = [&] {
    if (!words.back().empty() && words.size() < k_most_spoken) words.emplace_back();
  };
  const auto say = [&](std::string_view letters) {
    if (words.size() < k_most_spoken) words.back() += letters;
  };
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(base::utf8_sequence_length(text), 1);
    const std::string_view sign = text.substr(0, length);
    text.remove_prefix(length);
    const char c = base::lower(sign[0]);
    if (length > 1) {
      const char32_t code = code_of(sign);
      if (code == 0x2019) {
        if (!words.back().empty()) say("'");
      } else if (code == 0xdf || code == 0x1e9e) {
        say("ss");
      } else if (const std::string_view letters = latin_of(code); !letters.empty()) {
        say(letters);
      } else if (code >= 0x2000) {
        close();
      }
    } else if (c >= 'a' && c <= 'z') {
      say(std::string_view(&c, 1));
    } else if (c == '\'') {
      if (!words.back().empty()) say("'");
    } else if (c >= '0' && c <= '9') {
      close();
      say(k_digits[static_cast<std::size_t>(c - '0')]);
      close();
    } else {
      close();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

}  // namespace penpose::speech
