#pragma once

#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "core/rig/skeleton.h"

namespace penpose::rig {

/// Turns the triangles round that the skeleton at rest shows mirrored, so that they run counter-clockwise from outside
/// as they are shown: files tell it from the determinant of the transform (glTF 2.0, "Instantiation"). Twice is none.
/// Triangles of vertices that the skeleton does not have stay.
void turn_mirrored(const Skeleton& skeleton, std::span<mesh::Triangle> triangles);

}  // namespace penpose::rig
