#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace penpose::mesh {

/// An undirected edge and one triangle beside it.
struct EdgeUse {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t triangle = 0;
};

/// The three edges of every triangle, sorted by edge, then by triangle.
[[nodiscard]] std::vector<EdgeUse> sorted_edges(std::span<const Triangle> triangles, std::size_t vertex_count);

/// The lowest-numbered triangle that is a third one at an edge; nothing for a mesh whose edges are all manifold.
[[nodiscard]] std::optional<std::uint32_t> first_non_manifold_triangle(std::span<const Triangle> triangles,
                                                                       std::size_t vertex_count);

/// For every vertex the lowest-numbered vertex it is one with. Vertices of one part at exactly the same position are
/// welded where the welded part stays manifold (no edge with three triangles, no triangle that collapses); a part that
/// would not stays unwelded, because there the touching surfaces are separate things (lashes on a lid).
/// Two parts are welded along border edges that they share exactly, in opposite directions, if all of that leaves the
/// mesh manifold: one surface in two materials.
[[nodiscard]] std::vector<std::uint32_t> weld_coincident(const MeshSource& source);

/// For every vertex the lowest-numbered one that it is welded to and whose file normal points the same way (within
/// 1e-3); without file normals, the weld itself.
[[nodiscard]] std::vector<std::uint32_t> smoothing_groups(const MeshSource& source,
                                                          std::span<const std::uint32_t> weld);

struct Components {
  std::vector<std::uint32_t> component;  ///< one a vertex
  std::size_t count = 0;
};
/// Connected components over welded triangles, numbered in order of their lowest vertex. A vertex without a triangle is
/// a component.
[[nodiscard]] Components label_components(std::span<const Triangle> triangles, std::span<const std::uint32_t> weld);

}  // namespace penpose::mesh
