#pragma once

#include "core/base/result.h"
#include "core/mesh/quad_mesh.h"

namespace penpose::mesh {

/// One level of Catmull and Clark's subdivision (1978): every quad becomes four, borders become cubic B-splines. Vertex
/// v of the mesh is vertex v of the result; where new vertices stand in the result follows from the quads alone, so
/// that two meshes with equal quads can be subdivided side by side. A new quad starts with the vertex in the middle of
/// its parent; the vertex opposite to it is the one it shares with the cage. Errors: an index out of range, or quads
/// that are no manifold (place "quad N").
///
/// Sums are rounded in the order in which OpenMesh 9 forms them, with which the first sessions on the built-in head
/// were recorded; a test compares the two bit for bit.
[[nodiscard]] base::Result<QuadMesh> catmull_clark(const QuadMesh& mesh);

}  // namespace penpose::mesh
