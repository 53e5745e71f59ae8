#pragma once

#include "tests/judges/rigs/parts.h"

namespace penpose::judges {

/// The same face of fewer vertices: short edges are drawn together. Vertices of lines, of rims and of eyes stay, of
/// others this share.
[[nodiscard]] Parts thinned(const Parts& parts, double share);

}  // namespace penpose::judges
