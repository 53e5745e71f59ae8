#pragma once

#include <span>

#include "ui/app/action.h"

namespace penpose::app {

/// Actions of several characters.
[[nodiscard]] std::span<const ActionInfo> cast_actions();

}  // namespace penpose::app
