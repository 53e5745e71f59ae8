#pragma once

#include <optional>
#include <string>

#include "core/base/byte_reader.h"

namespace penpose::io {

/// The text of a file of UTF-16, which begins with a byte order mark, as UTF-8 without one. Nothing where it does not.
[[nodiscard]] std::optional<std::string> text_of_utf16(base::Bytes bytes);

/// A text whose bytes are no UTF-8, taken for ISO 8859-1, as UTF-8. Nothing where it is UTF-8 as it is.
[[nodiscard]] std::optional<std::string> text_of_latin1(std::string_view text);

/// Returns true for binary data: the first bytes contain zeros or other signs that text does not have.
[[nodiscard]] bool is_binary(base::Bytes bytes);

}  // namespace penpose::io
