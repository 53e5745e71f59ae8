#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace penpose::base {

/// Length of the UTF-8 sequence at the start of a text that is not empty; 0 where it is not valid (RFC 3629).
[[nodiscard]] std::size_t utf8_sequence_length(std::string_view text);

/// The text with every byte that is not part of valid UTF-8 replaced by "?", so that every format can write it.
[[nodiscard]] std::string valid_utf8(std::string_view text);

}  // namespace penpose::base
