#pragma once

#include <array>
#include <functional>

#include "core/mesh/mesh_point.h"

namespace penpose::portrait {

/// The colour of a model's surface at a place without any light: display values (sRGB) of red, green and blue and the
/// opacity, each 0..1. Empty if the model has no colours.
using SurfacePaint = std::function<std::array<double, 4>(const mesh::MeshPoint&)>;

}  // namespace penpose::portrait
