#include "ui/app/face/feature_words.h"

#include <algorithm>
#include <array>
#include <vector>

namespace penpose::app {

std::string feature_words(std::string_view name) {
  constexpr std::array<std::string_view, 6> k_before{"upper", "lower", "inner", "outer", "left", "right"};
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (c == '_' || c == ' ' || c == '.') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  for (std::string& word : words) {
    if (word == "L" || word == "l") word = "left";
    if (word == "R" || word == "r") word = "right";
  }
  // "lip upper outer left" is said the other way round.
  std::string before, noun;
  for (const std::string& word : words) {
    if (word.empty()) continue;
    if (std::find(k_before.begin(), k_before.end(), word) != k_before.end()) {
      before = word + " " + before;
    } else {
      noun += (noun.empty() ? "" : " ") + word;
    }
  }
  return before + noun;
}

}  // namespace penpose::app
