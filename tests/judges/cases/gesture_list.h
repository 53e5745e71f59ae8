#pragma once

#include <span>

#include "tests/judges/cases/gesture_kinds.h"

namespace penpose::judges {

/// The gestures that rigs are judged by.
[[nodiscard]] std::span<const GestureKind> gesture_kinds();

}  // namespace penpose::judges
