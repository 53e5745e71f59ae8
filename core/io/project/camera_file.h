#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/geometry/camera.h"

namespace penpose::io {

/// Reads {"eye": [x, y, z], "look_at": [x, y, z], "up": [x, y, z], "vertical_fov_degrees": a}. `up` (0, 1, 0) and the
/// angle (30) may be left out, other keys are ignored. Errors name the JSON pointer or the byte.
[[nodiscard]] base::Result<geometry::CameraPose> read_camera(base::Bytes bytes);

}  // namespace penpose::io
