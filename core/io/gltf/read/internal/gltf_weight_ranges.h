#pragma once

#include <vector>

#include "core/document/model.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_shapes.h"

namespace penpose::io {

/// Widens the ranges of shapes to all values that the animations give them, at keys and, for cubic splines, in between,
/// because glTF sets weights no limits and other programs play them as they are. Shapes that the extras list keep the
/// range that they have there. Precondition: weights channels hold one value a shape and key.
void widen_ranges(const std::vector<document::Animation>& animations, const RootExtras& extras, GltfShapes& shapes);

}  // namespace penpose::io
