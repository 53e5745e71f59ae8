#pragma once

#include "core/base/result.h"
#include "core/mesh/quad_mesh.h"

namespace penpose::mesh {

/// catmull_clark for machines without OpenMesh: the same bits, sums being rounded in the order in which OpenMesh 9
/// forms them; a test compares the two.
[[nodiscard]] base::Result<QuadMesh> catmull_clark_by_halfedges(const QuadMesh& mesh);

}  // namespace penpose::mesh
