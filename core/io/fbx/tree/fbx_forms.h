#pragma once

#include <string_view>

#include "core/io/fbx/tree/fbx_tree.h"

namespace penpose::io {

// The two forms of an FBX file, as of read_fbx_tree.

inline constexpr std::string_view k_fbx_magic("Kaydara FBX Binary  \0\x1a\0", 23);
inline constexpr std::uint32_t k_oldest_fbx = 7000;
inline constexpr int k_deepest_fbx_record = 32;

/// Precondition: begins with k_fbx_magic.
[[nodiscard]] base::Result<FbxTree> read_binary_fbx(base::Bytes bytes);
[[nodiscard]] base::Result<FbxTree> read_text_fbx(base::Bytes bytes);

/// That a file is older than what is read.
[[nodiscard]] base::Error old_fbx_version(std::uint32_t version);

}  // namespace penpose::io
