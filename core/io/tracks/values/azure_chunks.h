#pragma once

#include <optional>

#include "core/animation/track.h"
#include "core/base/json/json.h"
#include "core/base/result.h"

namespace penpose::io {

/// Chunks of Azure's speech service: {"FrameIndex": 0, "BlendShapes": [[55 numbers], ...]}, 60 frames a second, in a
/// list or as text in "animation" of viseme events ("Get facial position with viseme", "3D blend shapes"). A chunk that
/// begins at 0 again is the next sentence and follows. Nothing where the file has none. Errors: rows of other numbers.
[[nodiscard]] std::optional<base::Result<animation::WeightTrack>> read_azure_chunks(const json::Json& root);

}  // namespace penpose::io
