#pragma once

#include <string>

namespace penpose::files {

/// How to call this program from another shell, as root too: its absolute path.
[[nodiscard]] std::string own_program();

}  // namespace penpose::files
