#pragma once

#include <string>
#include <string_view>

namespace penpose::base {

/// The text with every byte that is not part of valid UTF-8 replaced by "?", so that every format can write it.
[[nodiscard]] std::string valid_utf8(std::string_view text);

}  // namespace penpose::base
