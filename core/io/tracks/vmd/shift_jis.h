#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/byte_reader.h"

namespace penpose::io {

/// Text of Microsoft's code page 932 (Shift-JIS) up to its first zero byte. "?" stands for what is no letter of it.
[[nodiscard]] std::string utf8_of_shift_jis(base::Bytes bytes);

struct ShiftJis {
  std::string bytes;
  bool whole = true;  ///< no letter was cut off or has no code there
};
/// The text as code page 932, of at most so many bytes, no letter cut in two. "?" stands for letters that it lacks.
[[nodiscard]] ShiftJis shift_jis_of(std::string_view utf8, std::size_t most_bytes);

}  // namespace penpose::io
