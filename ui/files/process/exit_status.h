#pragma once

namespace penpose::files {

// What the program's exit status says.
inline constexpr int k_success = 0;
inline constexpr int k_failure = 1;
inline constexpr int k_wrong_usage = 2;

}  // namespace penpose::files
