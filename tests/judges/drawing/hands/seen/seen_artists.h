#pragma once

#include "tests/judges/drawing/faces/artist.h"

// Artists by whose drawings anything may be set.

namespace penpose::judges::drawn {

[[nodiscard]] Artist cartoonist();
[[nodiscard]] Artist felt_pen();
[[nodiscard]] Artist sketcher();
[[nodiscard]] Artist paper_cutter();

}  // namespace penpose::judges::drawn
