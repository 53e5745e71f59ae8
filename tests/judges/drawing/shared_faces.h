#pragma once

#include <string>
#include <vector>

#include "tests/judges/shared/shared_sets.h"

namespace penpose::judges {

/// A face of the shared data, judged by its landmark curves: drawings of poses that are known, and the shared drawings,
/// each with what it means in its name. `name`: of the model's file, without its ending.
[[nodiscard]] SharedSet shared_face_set(const std::string& name);

}  // namespace penpose::judges
