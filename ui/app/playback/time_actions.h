#pragma once

#include <span>

#include "ui/app/action.h"

namespace penpose::app {

/// Actions of keys, of the timeline and of what is played.
[[nodiscard]] std::span<const ActionInfo> time_actions();

}  // namespace penpose::app
