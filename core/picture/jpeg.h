#pragma once

#include <cstdint>
#include <span>

#include "core/base/result.h"
#include "core/picture/image.h"

namespace penpose::picture {

/// The picture of a JPEG file, halved while it is read until no side is longer than `most_px`, an eighth of its size at
/// the least. Errors: no JPEG, damaged beyond reading, or of more than 16384 px a side. What is cut off is grey.
[[nodiscard]] base::Result<Image> decode_jpeg(std::span<const std::uint8_t> bytes, int most_px = 16384);

/// The picture made smaller by whole numbers, each px the mean of those that it stands for, until no side is longer
/// than `most_px`.
[[nodiscard]] Image shrunk(const Image& image, int most_px);

}  // namespace penpose::picture
