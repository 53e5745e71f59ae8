#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace penpose::base {

/// Length of the UTF-8 sequence at the start of a text that is not empty; 0 where it is not valid (RFC 3629).
[[nodiscard]] std::size_t utf8_sequence_length(std::string_view text);

/// How many bytes at the start of a text that is not empty stand as in a valid sequence, up to its length; 0 where none
/// can begin one. What comes up to them is what one sign of replacement stands for (Unicode 15, section 3.9).
[[nodiscard]] std::size_t utf8_begun(std::string_view text);
/// The sequence of a code point that is one: at most 0x10ffff and no surrogate.
[[nodiscard]] std::string utf8_of(char32_t code);

/// The text with every byte that is not part of valid UTF-8 replaced by "?", so that every format can write it.
[[nodiscard]] std::string valid_utf8(std::string_view text);

}  // namespace penpose::base
