#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace penpose::base {

/// A name that a file, a device or a user gave, as it may be printed on a terminal: what controls a terminal, what
/// turns the direction of writing and what is no UTF-8 stands as \xNN or \u{N}, and of a name of more than `most` bytes
/// the middle is left out.
[[nodiscard]] std::string shown_name(std::string_view name, std::size_t most = 120);

/// The same for a sentence with names in it: breaks of lines and tabs become blanks.
[[nodiscard]] std::string shown_line(std::string_view text, std::size_t most);

}  // namespace penpose::base
