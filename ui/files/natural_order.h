#pragma once

#include <string_view>

namespace penpose::files {

/// Whether a comes before b as people count: numbers within names are compared as numbers, so that k2 comes before k10,
/// all else byte by byte. Names that differ in leading zeros only are in the order of their bytes.
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

}  // namespace penpose::files
