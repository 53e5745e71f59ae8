#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/byte_reader.h"

namespace penpose::io {

/// What the first bytes of a picture say of it. Nothing is unpacked.
struct PictureHead {
  std::string mime_type;    ///< "image/png", "image/jpeg", "image/webp", "image/ktx2"
  std::uint32_t width = 0;  ///< px
  std::uint32_t height = 0;
  bool whole = true;  ///< false: the file ends before the picture does (PNG, WebP)
};

/// Tells a PNG, JPEG, WebP or KTX2 picture by its content and finds its size. Takes time with the number of the file's
/// chunks, at most a step a dozen bytes. Nothing: no picture of these, or one whose size cannot be found.
[[nodiscard]] std::optional<PictureHead> read_picture_head(base::Bytes bytes);

}  // namespace penpose::io
