#include "core/base/result.h"

namespace penpose::base {

std::string Error::line(std::string_view file) const {
  std::string text;
  const auto add = [&text](std::string_view piece, std::string_view separator) {
    if (piece.empty()) return;
    if (!text.empty()) text += separator;
    text += piece;
  };
  add(file, "");
  add(place, ": ");
  add(what, ": ");
  add(remedy, "; ");
  // An error is one line whatever a hostile file put into its names.
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return text;
}

}  // namespace penpose::base
