#pragma once

#include <cstdint>
#include <string>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::device {

// String descriptors (USB 2.0, 9.6.7), whoever asks for them.

/// A device that does not answer costs this.
inline constexpr unsigned k_string_timeout_ms = 500;

/// The language in which a string is asked for: American English, and none for the list of languages itself.
[[nodiscard]] std::uint16_t language_of_string(std::uint8_t index);

/// The text of a string descriptor; characters outside ASCII come as '?'. Errors: it is none.
[[nodiscard]] base::Result<std::string> text_of_string(base::Bytes descriptor, std::uint8_t index);

}  // namespace penpose::device
