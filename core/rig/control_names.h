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
/// eyeBlink_L, EyeBlinkLeft and eye-blink-left are one. Letters of other scripts stay as they are.
[[nodiscard]] std::string folded_name(std::string_view name);

/// What stands before the name proper in the names of one mesh or file, shared by all or many of them: "blendShape1."
/// of blendShape1.jawOpen, "CTRL_expressions_" of CTRL_expressions_jawOpen. A prefix ends with a sign that is neither
/// letter nor digit, or where a capital begins ("bsJawOpen"). Those that two names or more begin with are given, and
/// those of a single name that end with ".", ":", "|" or "__", as programs write the object before a name. Longest
/// first, each once.
[[nodiscard]] std::vector<std::string> shared_prefixes(std::span<const std::string_view> names);

/// The controls that a name of another program means: the one of that folded name, or where there is none, those of it
/// with a side behind it (browInnerUp: browInnerUp_L and browInnerUp_R), or where there are none, the same among the
/// names without a prefix that several controls share (shared_prefixes): then each mesh's own. Where there is none of
/// these either, those whose name means the same (face_name): on the same side, or else on none; of several that mean
/// it, the first by the table. Ascending; empty: none.
[[nodiscard]] std::vector<std::size_t> controls_named(std::span<const Parameter> parameters, std::string_view name);

}  // namespace penpose::rig
