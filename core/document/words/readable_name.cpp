#include "core/document/words/readable_name.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/text/letters.h"

namespace penpose::document {
namespace {

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_sign(char c) { return static_cast<unsigned char>(c) < 0x80 && !is_capital(c) && !is_small(c) && !is_digit(c); }

/// What stands between signs, and from a capital after a small letter on.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  bool open = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (is_sign(c)) {
      open = false;
      continue;
    }
    const bool begins = is_capital(c) && i > 0 && (is_small(name[i - 1]) || is_digit(name[i - 1]));
    if (!open || begins) words.emplace_back();
    open = true;
    words.back() += c;
  }
  return words;
}

/// Words that say what a thing is to a program, not to a person.
constexpr std::array<std::string_view, 9> k_noise{"jnt", "joint", "bone",  "anim", "ctrl",
                                                  "bs",  "blend", "shape", "def"};

bool is_noise(std::string_view word) { return std::find(k_noise.begin(), k_noise.end(), word) != k_noise.end(); }

}  // namespace

ReadableName readable_name(std::string_view name) {
  ReadableName out;
  // Programs write the object before a name.
  const std::size_t object = name.find_last_of(".:|");
  const std::string_view own =
      object == std::string_view::npos || object + 1 == name.size() ? name : name.substr(object + 1);
  for (const std::string& word : words_of(own)) {
    const std::string small = base::lower_case(word);
    const bool left = small == "left" || word == "L" || (word == "l" && !out.what.empty());
    const bool right = small == "right" || word == "R" || (word == "r" && !out.what.empty());
    if ((left || right) && out.side == FaceSide::both) {
      out.side = left ? FaceSide::left : FaceSide::right;
      continue;
    }
    if (!is_noise(small)) out.what += (out.what.empty() ? "" : " ") + small;
  }
  if (out.what.empty()) out = {std::string(name), FaceSide::both};
  return out;
}

}  // namespace penpose::document
