#pragma once

#include "core/base/json/json.h"
#include "core/character/character.h"

// What answers say of a character.

namespace penpose::serve {

/// The parameters that are not at rest.
[[nodiscard]] json::Json pose_json(const character::Character& one);
/// How far what has a target or a place is from it: the mean and the most of each curve.
[[nodiscard]] json::Json distances_json(const character::Character& one);

}  // namespace penpose::serve
