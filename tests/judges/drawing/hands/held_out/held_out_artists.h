#pragma once

#include "tests/judges/drawing/faces/artist.h"

// Artists by whose drawings nobody sets anything: they show what the others hide.

namespace penpose::judges::drawn {

[[nodiscard]] Artist storyteller();
[[nodiscard]] Artist passer_by();

}  // namespace penpose::judges::drawn
