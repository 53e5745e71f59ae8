#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace penpose::speech {

/// How a file spells phonemes: ARPAbet as the CMU dictionary and TIMIT do (with digits of stress, in any case, with the
/// places "_B", "_I", "_E" and "_S" of Kaldi), the International Phonetic Alphabet (2020), or X-SAMPA (Wells 1995).
enum class PhoneAlphabet : std::uint8_t { arpabet, ipa, sampa };

/// The phoneme of the CMU dictionary that sounds most like a label; a diphthong or an affricate is one label. "": a
/// pause. Nothing where it is none in the alphabet.
[[nodiscard]] std::optional<std::string> phoneme_of_label(std::string_view label, PhoneAlphabet alphabet);

/// Returns true if a label means that nobody speaks: "", "sil", "sp", "<eps>", "pau", "h#" and the like, in any case.
[[nodiscard]] bool is_pause_label(std::string_view label);
/// Returns true if a label stands for unknown speech: "spn", "oov".
[[nodiscard]] bool is_unknown_label(std::string_view label);

/// The alphabet in which most of the labels are phonemes, and how many are; pauses are in all.
struct SpelledPhones {
  PhoneAlphabet alphabet = PhoneAlphabet::arpabet;
  std::size_t known = 0;   ///< phonemes among them
  std::size_t spoken = 0;  ///< labels that are no pause
};
[[nodiscard]] SpelledPhones spelling_of(const std::vector<std::string_view>& labels);

}  // namespace penpose::speech
