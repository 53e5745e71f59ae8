#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/rig/rig.h"

namespace penpose::rig {

/// A name as programs agree on it: small letters and digits only, "left" and "right" at its end as "l" and "r", so that
/// eyeBlink_L, EyeBlinkLeft and eye-blink-left are one.
[[nodiscard]] std::string folded_name(std::string_view name);

/// The controls that a name of another program means: the one of that folded name, or where there is none, those of it
/// with a side behind it (browInnerUp: browInnerUp_L and browInnerUp_R). Ascending; empty: none.
[[nodiscard]] std::vector<std::size_t> controls_named(std::span<const Parameter> parameters, std::string_view name);

}  // namespace penpose::rig
