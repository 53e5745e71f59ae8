#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"

namespace penpose::poses {

/// Bytes as text (RFC 4648, section 4).
[[nodiscard]] std::string base64_text(base::Bytes bytes);
/// Nothing where there is another character or a length that cannot be.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> base64_bytes(std::string_view text);

}  // namespace penpose::poses
