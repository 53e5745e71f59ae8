#pragma once

#include <string_view>

namespace penpose::demo {

// What was drawn for the demo, compiled into the program so that it needs no data folder. The source file is made by
// CMake.

/// A sketch file (core/model_io/sketch_file.h) of the deformers of the built-in head.
[[nodiscard]] std::string_view embedded_sketch();
/// An expression file (ui/demo/expression_file.h).
[[nodiscard]] std::string_view embedded_expressions();

}  // namespace penpose::demo
