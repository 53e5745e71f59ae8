#pragma once

#include <span>
#include <string>

namespace penpose::app {

/// The file of the first of these families that is installed, in its upright, regular cut; empty: none of them is.
[[nodiscard]] std::string font_file(std::span<const char* const> families);

}  // namespace penpose::app
