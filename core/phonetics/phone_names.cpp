#include "core/phonetics/phone_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/base/text/utf8.h"
#include "core/phonetics/nine_mouths.h"

namespace penpose::speech {
namespace {

/// Two letters are one phoneme where a vowel glides, or a stop opens as a fricative.
enum class Kind : std::uint8_t { vowel, glide, stop, fricative, other };

struct Letter {
  std::string_view sign;
  std::string_view phoneme;
  Kind kind;
};

using enum Kind;

/// Signs of the International Phonetic Alphabet with the phoneme whose mouth is theirs.
constexpr Letter k_ipa[]{
    {"a", "AA", vowel},     {"ɑ", "AA", vowel},     {"ɐ", "AH", vowel},     {"æ", "AE", vowel},
    {"ʌ", "AH", vowel},     {"ə", "AH", vowel},     {"ɘ", "AH", vowel},     {"ɜ", "ER", vowel},
    {"ɞ", "ER", vowel},     {"ɚ", "ER", vowel},     {"ɝ", "ER", vowel},     {"e", "EH", vowel},
    {"ɛ", "EH", vowel},     {"i", "IY", vowel},     {"ɪ", "IH", vowel},     {"ɨ", "IH", vowel},
    {"ᵻ", "IH", vowel},     {"ɯ", "IH", vowel},     {"ɤ", "AH", vowel},     {"y", "UW", vowel},
    {"ʏ", "UH", vowel},     {"ø", "OW", vowel},     {"œ", "AO", vowel},     {"ɶ", "AO", vowel},
    {"o", "OW", vowel},     {"ɔ", "AO", vowel},     {"ɒ", "AO", vowel},     {"u", "UW", vowel},
    {"ʊ", "UH", vowel},     {"ʉ", "UW", vowel},     {"ɵ", "UH", vowel},     {"j", "Y", glide},
    {"w", "W", glide},      {"ɥ", "W", glide},      {"ʍ", "W", glide},      {"ɰ", "Y", glide},
    {"p", "P", stop},       {"b", "B", stop},       {"ɓ", "B", stop},       {"t", "T", stop},
    {"d", "D", stop},       {"ʈ", "T", stop},       {"ɖ", "D", stop},       {"ɗ", "D", stop},
    {"c", "K", stop},       {"ɟ", "G", stop},       {"ʄ", "G", stop},       {"k", "K", stop},
    {"g", "G", stop},       {"ɡ", "G", stop},       {"ɠ", "G", stop},       {"q", "K", stop},
    {"ɢ", "G", stop},       {"ʛ", "G", stop},       {"ʔ", "HH", other},     {"ʡ", "HH", other},
    {"m", "M", other},      {"ɱ", "V", other},      {"n", "N", other},      {"ɳ", "N", other},
    {"ɲ", "N", other},      {"ŋ", "NG", other},     {"ɴ", "NG", other},     {"ʙ", "B", other},
    {"r", "R", glide},      {"ʀ", "R", glide},      {"ɹ", "R", glide},      {"ɻ", "R", glide},
    {"ɾ", "D", other},      {"ɽ", "D", other},      {"ʁ", "R", fricative},  {"ɸ", "F", fricative},
    {"β", "B", fricative},  {"f", "F", fricative},  {"v", "V", fricative},  {"ʋ", "V", other},
    {"ⱱ", "V", other},      {"θ", "TH", fricative}, {"ð", "DH", fricative}, {"s", "S", fricative},
    {"z", "Z", fricative},  {"ʃ", "SH", fricative}, {"ʒ", "ZH", fricative}, {"ɕ", "SH", fricative},
    {"ʑ", "ZH", fricative}, {"ʂ", "SH", fricative}, {"ʐ", "ZH", fricative}, {"ç", "HH", fricative},
    {"ʝ", "Y", fricative},  {"x", "HH", fricative}, {"ɣ", "G", fricative},  {"χ", "HH", fricative},
    {"ħ", "HH", fricative}, {"ʕ", "HH", fricative}, {"ʜ", "HH", fricative}, {"ʢ", "HH", fricative},
    {"h", "HH", fricative}, {"ɦ", "HH", fricative}, {"ɧ", "SH", fricative}, {"l", "L", other},
    {"ɫ", "L", other},      {"ɭ", "L", other},      {"ʎ", "L", other},      {"ʟ", "L", other},
    {"ɬ", "L", fricative},  {"ɮ", "L", fricative},  {"ɺ", "L", other},      {"ʦ", "T", other},
    {"ʣ", "D", other},      {"ʧ", "CH", other},     {"ʤ", "JH", other},     {"ʨ", "CH", other},
    {"ʥ", "JH", other},
};

/// X-SAMPA, and what SAMPA of German and English writes otherwise.
constexpr Letter k_sampa[]{
    {"a", "AA", vowel},     {"A", "AA", vowel},     {"6", "AH", vowel},     {"{", "AE", vowel},
    {"V", "AH", vowel},     {"@", "AH", vowel},     {"3", "ER", vowel},     {"e", "EH", vowel},
    {"E", "EH", vowel},     {"i", "IY", vowel},     {"I", "IH", vowel},     {"1", "IH", vowel},
    {"M", "IH", vowel},     {"7", "AH", vowel},     {"y", "UW", vowel},     {"Y", "UH", vowel},
    {"2", "OW", vowel},     {"9", "AO", vowel},     {"&", "AO", vowel},     {"o", "OW", vowel},
    {"O", "AO", vowel},     {"Q", "AO", vowel},     {"u", "UW", vowel},     {"U", "UH", vowel},
    {"}", "UW", vowel},     {"8", "UH", vowel},     {"j", "Y", glide},      {"w", "W", glide},
    {"H", "W", glide},      {"W", "W", glide},      {"p", "P", stop},       {"b", "B", stop},
    {"t", "T", stop},       {"d", "D", stop},       {"c", "K", stop},       {"k", "K", stop},
    {"g", "G", stop},       {"q", "K", stop},       {"?", "HH", other},     {"m", "M", other},
    {"F", "V", other},      {"n", "N", other},      {"J", "N", other},      {"N", "NG", other},
    {"r", "R", glide},      {"R", "R", glide},      {"4", "D", other},      {"B", "B", fricative},
    {"f", "F", fricative},  {"v", "V", fricative},  {"P", "V", other},      {"T", "TH", fricative},
    {"D", "DH", fricative}, {"s", "S", fricative},  {"z", "Z", fricative},  {"S", "SH", fricative},
    {"Z", "ZH", fricative}, {"C", "HH", fricative}, {"x", "HH", fricative}, {"G", "G", fricative},
    {"X", "HH", fricative}, {"h", "HH", fricative}, {"l", "L", other},      {"L", "L", other},
    {"K", "L", fricative},
};

/// Lists the signs that TIMIT and others use in addition to the phonemes of the CMU dictionary.
constexpr std::pair<std::string_view, std::string_view> k_more_arpabet[]{
    {"AX", "AH"}, {"AX-H", "AH"}, {"IX", "IH"}, {"AXR", "ER"}, {"UX", "UW"}, {"EL", "L"},  {"EM", "M"},
    {"EN", "N"},  {"ENG", "NG"},  {"DX", "D"},  {"NX", "N"},   {"HV", "HH"}, {"Q", "HH"},  {"BCL", "B"},
    {"PCL", "P"}, {"DCL", "D"},   {"TCL", "T"}, {"GCL", "G"},  {"KCL", "K"}, {"OH", "AO"}, {"EA", "EH"},
    {"IA", "IH"}, {"UA", "UH"},   {"OO", "UH"}, {"WH", "W"},   {"NY", "N"},
};

constexpr std::string_view k_pauses[]{"sil",   "ns",   "<ns>", "sp",    "<sp>",         "<sil>",   "<eps>", "pau",
                                      "pause", "epi",  "h#",   "#",     "##",           "_",       "-",     "<p:>",
                                      "<p>",   "ssil", "nsn",  "<nsn>", "[sil]",        "silence", "(sil)", "brth",
                                      "{sl}",  "<b>",  "rest", "...",   "\xe2\x80\xa6", "<usb>",   "noi"};

std::string_view without_digits(std::string_view text) {
  while (!text.empty() && text.back() >= '0' && text.back() <= '9') text.remove_suffix(1);
  return text;
}

std::optional<std::string> arpabet(std::string_view label) {
  if (label.size() > 2 && label[label.size() - 2] == '_') label.remove_suffix(2);
  const std::string_view bare = without_digits(label);
  for (const auto& [name, phoneme] : k_more_arpabet) {
    if (base::same_but_case(bare, name)) return std::string(phoneme);
  }
  if (mouth_of_phoneme(bare) == NineMouth::rest) return std::nullopt;
  std::string name;
  for (const char c : bare) name += base::upper(c);
  return name;
}

/// Signs that change how a letter sounds rather than how it looks: combining marks (U+0300 to U+036F), raised letters
/// (U+02B0 to U+02FF), tie bars, tones and signs of place.
bool is_diacritic(std::string_view sign) {
  if (sign.size() == 2) {
    const unsigned code =
        (static_cast<unsigned char>(sign[0]) & 0x1fU) << 6U | (static_cast<unsigned char>(sign[1]) & 0x3fU);
    return (code >= 0x2b0 && code <= 0x36f) || (code >= 0xb0 && code <= 0xb9);
  }
  if (sign.size() == 3) {
    // Raised letters (U+1D2C to U+1D6A, U+1D9B to U+1DFF) and numbers (U+2070 to U+208E), arrows of tones.
    const unsigned code = (static_cast<unsigned char>(sign[0]) & 0x0fU) << 12U |
                          (static_cast<unsigned char>(sign[1]) & 0x3fU) << 6U |
                          (static_cast<unsigned char>(sign[2]) & 0x3fU);
    return (code >= 0x1d2c && code <= 0x1d6a) || (code >= 0x1d9b && code <= 0x1dff) ||
           (code >= 0x2070 && code <= 0x209f) || (code >= 0xa700 && code <= 0xa71f) ||
           (code >= 0x2190 && code <= 0x21ff) || code == 0x203f;
  }
  return false;
}

/// Lists the diacritics of X-SAMPA that do not change a mouth.
bool is_sampa_mark(char c) { return std::string_view(":~`'\"%=_\\^<>-!|.+").find(c) != std::string_view::npos; }

const Letter* find_letter(std::string_view sign, PhoneAlphabet alphabet) {
  const auto in = [&](const auto& table) {
    const auto* found =
        std::find_if(std::begin(table), std::end(table), [&](const Letter& l) { return l.sign == sign; });
    return found == std::end(table) ? nullptr : found;
  };
  return alphabet == PhoneAlphabet::ipa ? in(k_ipa) : in(k_sampa);
}

/// Letters that are one sound: one, a vowel that glides on, or a stop that opens as a fricative.
std::optional<std::string> one_sound(std::string_view label, PhoneAlphabet alphabet) {
  std::vector<const Letter*> letters;
  while (!label.empty()) {
    const std::size_t length = std::max<std::size_t>(base::utf8_sequence_length(label), 1);
    const std::string_view sign = label.substr(0, length);
    label.remove_prefix(length);
    if (alphabet == PhoneAlphabet::ipa ? is_diacritic(sign) || sign == ":" || (sign >= "0" && sign <= "9")
                                       : length == 1 && is_sampa_mark(sign[0])) {
      continue;
    }
    const Letter* letter = find_letter(sign, alphabet);
    if (letter == nullptr || letters.size() == 3) return std::nullopt;
    letters.push_back(letter);
  }
  if (letters.empty()) return std::nullopt;
  const Letter& first = *letters[0];
  for (std::size_t i = 1; i < letters.size(); ++i) {
    const Letter& before = *letters[i - 1];
    const Letter& letter = *letters[i];
    const bool glides = before.kind == vowel && (letter.kind == vowel || letter.kind == glide);
    const bool opens = i == 1 && before.kind == stop && letter.kind == fricative;
    const bool is_long = before.sign == letter.sign;
    if (!glides && !opens && !is_long) return std::nullopt;
  }
  // The mouth of the two is that of the CMU dictionary's AW.
  const bool rounds = letters.size() > 1 && first.phoneme == "AA" &&
                      (letters[1]->phoneme == "UH" || letters[1]->phoneme == "UW" || letters[1]->phoneme == "W");
  return std::string(rounds ? "AW" : first.phoneme);
}

}  // namespace

bool is_pause_label(std::string_view label) {
  label = base::trim(label);
  return label.empty() || std::any_of(std::begin(k_pauses), std::end(k_pauses),
                                      [&](std::string_view one) { return base::same_but_case(one, label); });
}

bool is_unknown_label(std::string_view label) {
  constexpr std::array<std::string_view, 6> k_unknown{"spn", "<unk>", "oov", "<spn>", "[unk]", "unk"};
  const std::string_view bare = base::trim(label);
  return std::any_of(k_unknown.begin(), k_unknown.end(),
                     [&](std::string_view one) { return base::same_but_case(one, bare); });
}

std::optional<std::string> phoneme_of_label(std::string_view label, PhoneAlphabet alphabet) {
  label = base::trim(label);
  if (is_pause_label(label)) return std::string();
  return alphabet == PhoneAlphabet::arpabet ? arpabet(label) : one_sound(label, alphabet);
}

SpelledPhones spelling_of(const std::vector<std::string_view>& labels) {
  SpelledPhones best;
  for (const PhoneAlphabet alphabet : {PhoneAlphabet::arpabet, PhoneAlphabet::ipa, PhoneAlphabet::sampa}) {
    SpelledPhones one{alphabet};
    for (const std::string_view label : labels) {
      if (is_pause_label(label)) continue;
      ++one.spoken;
      if (is_unknown_label(label) || phoneme_of_label(label, alphabet)) ++one.known;
    }
    if (one.known > best.known || alphabet == PhoneAlphabet::arpabet) best = one;
  }
  return best;
}

}  // namespace penpose::speech
