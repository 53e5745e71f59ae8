#pragma once

#include "tests/judges/rigs/parts.h"

namespace penpose::judges {

/// The same face of about this share of its vertices: short edges are drawn together. Vertices of lines, of rims and of
/// eyes stay, and with them what is between lips and lids.
[[nodiscard]] Parts thinned(const Parts& parts, double share);

}  // namespace penpose::judges
