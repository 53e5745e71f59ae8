#pragma once

#include <span>

#include "ui/app/action.h"

namespace penpose::app {

/// Actions of kept views and of the camera that moves along the timeline, in a row each.
[[nodiscard]] std::span<const ActionInfo> camera_actions();
/// True for what goes to the view of one key, or keeps one on it.
[[nodiscard]] bool is_camera_key(Action action);

}  // namespace penpose::app
