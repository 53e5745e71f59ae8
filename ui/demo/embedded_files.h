#pragma once

#include <string_view>

namespace penpose::demo {

/// The session of the demo (replay/session/session_line.h): a pen that sketches the controls of the built-in head and
/// poses it. Compiled into the program so that it needs no data folder. CMake makes the source.
[[nodiscard]] std::string_view embedded_session();

}  // namespace penpose::demo
