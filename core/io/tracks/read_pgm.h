#pragma once

#include "core/animation/points/eigen_points.h"
#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

/// A portable grey map, binary (P5) or text (P2), of up to 8 bits a pixel, scaled to 0..255. Errors (place "byte offset
/// N"): another format, sizes of 0 or above 16384, fewer pixels than the header says.
[[nodiscard]] base::Result<animation::GreyImage> read_pgm(base::Bytes bytes);

}  // namespace penpose::io
