#include "core/mesh/triangle_mesh.h"

int vertices_of(const penpose::mesh::TriangleMesh& mesh) { return static_cast<int>(mesh.vertex_count()); }
