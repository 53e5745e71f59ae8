#pragma once

#include <span>

#include "core/base/state_hash.h"
#include "core/document/model.h"

namespace penpose::document {

// Pieces of the canonical form of a model (method, section 5).

/// The hash of mesh, blend shapes and skeleton.
[[nodiscard]] base::Hash128 hash_surface(const Model& model);
/// Returns a hash of the number of vertices and the triangles alone. It is the same for all forms of one mesh.
[[nodiscard]] base::Hash128 hash_topology(const mesh::TriangleMesh& mesh);
void add_parameters(base::StateHash& hash, const rig::Rig& rig);
void add_mesh_points(base::StateHash& hash, std::span<const mesh::MeshPoint> points);
void add_curves(base::StateHash& hash, std::span<const NamedCurve> curves);
/// Without those of these numbers.
void add_animations(base::StateHash& hash, std::span<const Animation> animations, std::span<const std::size_t> without);

}  // namespace penpose::document
