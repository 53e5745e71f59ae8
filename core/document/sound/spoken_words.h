#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace penpose::document {

/// A word that is said in the sound.
struct SpokenWord {
  double from_s = 0;  ///< of the sound, from 0
  std::string word;
  friend bool operator==(const SpokenWord&, const SpokenWord&) = default;
};
/// Ascending in time.
using SpokenWords = std::vector<SpokenWord>;

inline constexpr std::size_t k_most_words = 100000;
inline constexpr std::size_t k_longest_word = 200;  ///< bytes

}  // namespace penpose::document
