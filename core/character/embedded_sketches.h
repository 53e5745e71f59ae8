#pragma once

#include <string_view>

namespace penpose::character {

/// The sketch file of the built-in head's controls (core/character/demo_sketches.json), compiled into the library so
/// that it needs no data folder. CMake makes the source.
[[nodiscard]] std::string_view embedded_sketches();

}  // namespace penpose::character
