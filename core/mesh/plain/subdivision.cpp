#include "core/mesh/subdivision.h"

#include "core/mesh/subdivision_by_halfedges.h"

// Where there is no OpenMesh: Debian has it for 64-bit machines alone.

namespace penpose::mesh {

base::Result<QuadMesh> catmull_clark(const QuadMesh& mesh) { return catmull_clark_by_halfedges(mesh); }

}  // namespace penpose::mesh
