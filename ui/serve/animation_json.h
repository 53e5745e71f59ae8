#pragma once

#include <optional>

#include "core/base/json/json.h"
#include "core/tracking/animate.h"

namespace penpose::serve {

/// What `penpose animate --json` and the conversation say of an animation: one list a parameter with a value a frame,
/// and beside it how the head turned, degrees (pitch: down, yaw: to the picture's right, roll: clockwise) and px.
/// `solve_us`: microseconds a frame, where they were measured.
[[nodiscard]] json::Json animation_json(const tracking::Animated& animated, std::optional<double> solve_us = {});

}  // namespace penpose::serve
