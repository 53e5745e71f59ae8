#pragma once

namespace penpose::rig {

[[nodiscard]] inline bool is_small(char c) { return c >= 'a' && c <= 'z'; }
[[nodiscard]] inline bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
[[nodiscard]] inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// A byte of a letter that is not of ASCII.
[[nodiscard]] inline bool is_other_script(char c) { return static_cast<unsigned char>(c) >= 0x80; }

}  // namespace penpose::rig
