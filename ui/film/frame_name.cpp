#include "ui/film/frame_name.h"

#include <algorithm>

namespace penpose::film {

std::string frame_name(const std::string& pattern, std::size_t number) {
  std::string stem = pattern.ends_with(".png") ? pattern.substr(0, pattern.size() - 4) : pattern;
  const std::size_t after = stem.find_last_not_of('#') + 1;
  const std::size_t width = after < stem.size() ? stem.size() - after : 4;
  stem.resize(after);
  std::string digits = std::to_string(number);
  while (digits.size() < width) digits.insert(digits.begin(), '0');
  return stem + digits + ".png";
}

}  // namespace penpose::film
