#pragma once

#include <string_view>

#include "core/head/head.h"

namespace penpose::demo {

/// The session of the demo (replay/session/session_line.h): a pen that sketches the deformers of an edition of the
/// built-in head and poses it. Compiled into the program so that it needs no data folder. The source file is made by
/// CMake.
[[nodiscard]] std::string_view embedded_session(head::HeadEdition edition);

}  // namespace penpose::demo
