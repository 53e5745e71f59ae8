#pragma once

#include <string_view>

namespace penpose::decode {

// The project's own tables, compiled into the program from the folder `tablets`. The source file is made by CMake.

[[nodiscard]] std::string_view embedded_protocols();
[[nodiscard]] std::string_view embedded_tablets();

}  // namespace penpose::decode
