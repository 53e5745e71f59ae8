#pragma once

#include <cstdint>
#include <span>

#include "core/base/result.h"
#include "core/picture/image.h"

namespace penpose::picture {

/// The picture of a PNG, JPEG or WebP file, told by its content, made smaller while it is unpacked until no side is
/// longer than `most_px` (at least 1). Memory is that of the smaller picture and a few rows; of interlaced PNG files,
/// which are taken up to 4096 x 4096 px, and of JPEG files in steps of a half, somewhat more. Errors: another kind of
/// file, damaged, cut off (PNG and WebP; of a JPEG what is cut off is grey), of more than 8192 x 8192 px in all, or of
/// far more px than the file has bytes.
[[nodiscard]] base::Result<Image> decode_picture(std::span<const std::uint8_t> bytes, int most_px);

}  // namespace penpose::picture
