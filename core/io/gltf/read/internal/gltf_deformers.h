#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/articulation/sketched_deformers.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_shapes.h"
#include "core/rig/skeleton.h"

namespace penpose::io {

/// Builds the sketched deformers of a file again from their strokes. One whose strokes no longer belong to the mesh, or
/// that does not do what its morph target says, is left a blend shape, with a note. Null when there is none.
[[nodiscard]] std::shared_ptr<const articulation::SketchedDeformers> read_deformers(
    const std::shared_ptr<const mesh::TriangleMesh>& mesh, const rig::Skeleton* skeleton, const RootExtras& extras,
    const GltfShapes& shapes, std::vector<std::string>& notes);

}  // namespace penpose::io
