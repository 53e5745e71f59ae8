#pragma once

namespace penpose::io {

// What to do about a file whose bytes contradict each other, or end too early.
inline constexpr const char* k_export_again = "the file is damaged; export it again";
inline constexpr const char* k_copy_again = "the file is cut off or damaged; copy or export it again";

}  // namespace penpose::io
