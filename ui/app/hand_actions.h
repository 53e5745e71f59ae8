#pragma once

#include <span>
#include <string>

#include "ui/app/action.h"

namespace penpose::app {

/// Actions of the hand that draws and of what it draws with: how steady it is, its tablet, what was drawn before.
[[nodiscard]] std::span<const ActionInfo> hand_actions();

/// How steady a hand is called that strays by `unsteadiness`, where 1 is usual.
[[nodiscard]] const char* steadiness_words(double unsteadiness);

}  // namespace penpose::app
