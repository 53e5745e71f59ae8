#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace penpose::io {

[[nodiscard]] bool is_data_uri(std::string_view uri);
/// The bytes of a "data:" URI (RFC 2397): base64, of either alphabet, or characters with %XX. Errors (without a place):
/// no comma, a character that is not base64.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> decode_data_uri(std::string_view uri);

/// The relative path that a URI of a file beside the model means, with %XX resolved, slashes for the backslashes of
/// programs on Windows, and without pieces that say nothing ("./", "//"), so that one file has one name. Nothing where
/// it leads out of the folder, or names nothing.
[[nodiscard]] std::optional<std::string> path_of_uri(std::string_view uri);
/// The same for a name that was written without %XX for its own % signs.
[[nodiscard]] std::optional<std::string> path_as_written(std::string_view uri);

}  // namespace penpose::io
