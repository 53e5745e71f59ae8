#include "core/base/result.h"

#include "core/base/text/shown_text.h"

namespace penpose::base {

std::string Error::line(std::string_view file) const {
  std::string text;
  const auto add = [&text](std::string_view piece, std::string_view separator) {
    if (piece.empty()) return;
    if (!text.empty()) text += separator;
    text += piece;
  };
  // An error is one line that can be read, whatever a hostile file put into its names.
  constexpr std::size_t k_longest_path = 4096;
  constexpr std::size_t k_longest_place = 500;
  constexpr std::size_t k_longest_piece = 1500;
  add(shown_line(file, k_longest_path), "");
  add(shown_line(place, k_longest_place), ": ");
  add(shown_line(what, k_longest_place), ": ");
  add(shown_line(remedy, k_longest_piece), "; ");
  return text;
}

}  // namespace penpose::base
