#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penpose::speech {

/// The words of a text (UTF-8) of any language as words_of gives them, with what it leaves out: digits are said one by
/// one, in English; Latin letters lose their marks (é e, ö o, ß ss); Greek, Cyrillic and kana become the Latin letters
/// that sound like them; a letter of any other script is a syllable with an open mouth, "ta". At most 200,000.
[[nodiscard]] std::vector<std::string> words_spoken(std::string_view text);

}  // namespace penpose::speech
