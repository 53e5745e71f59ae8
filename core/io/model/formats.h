#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/byte_reader.h"

namespace penpose::io {

enum class Format : std::uint8_t { glb, gltf, obj, ply, off, stl };

/// The format that the extension of a file name stands for, in upper or lower case.
[[nodiscard]] std::optional<Format> format_of_name(std::string_view file_name);

/// The format that the first bytes and the size of the file show, where they leave no doubt.
[[nodiscard]] std::optional<Format> format_of_content(base::Bytes bytes);

}  // namespace penpose::io
