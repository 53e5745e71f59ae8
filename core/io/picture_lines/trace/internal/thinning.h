#pragma once

#include <cstdint>
#include <vector>

#include "core/io/picture_lines/trace/internal/bitmap.h"

namespace penpose::io {

/// Closes holes of at most `most_px` px in what is not 0, which the grain of paper makes. Px of holes get 1.
void close_holes(Bitmap& mask, int most_px);

/// Thins what is not 0 to lines of one px that hang together as it did (Guo and Hall 1989, "Parallel thinning with
/// two-subiteration algorithms", algorithm A1), and returns the places of the px that are left, from above.
std::vector<std::uint32_t> thin(Bitmap& mask);

}  // namespace penpose::io
