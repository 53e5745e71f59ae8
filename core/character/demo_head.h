#pragma once

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::character {

/// The built-in head (core/head) with the controls that the demo sketches, at rest ("builtin:demo"). Errors: those of
/// the sketches, which the library brings along.
[[nodiscard]] base::Result<document::Model> make_demo_head();

}  // namespace penpose::character
