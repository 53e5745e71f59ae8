#pragma once

#include <span>

#include "ui/app/action.h"

namespace penpose::app {

/// Actions about which controls may move, and about a control that was just made.
[[nodiscard]] std::span<const ActionInfo> control_actions();

}  // namespace penpose::app
