#pragma once

#include <string_view>

namespace penpose::base {

/// The program's version, "0.2.0", as CMakeLists.txt has it.
extern const std::string_view k_version;
/// The same for C.
extern const char* const k_version_text;

}  // namespace penpose::base
