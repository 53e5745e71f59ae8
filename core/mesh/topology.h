#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace penpose::mesh {

/// An undirected edge and one triangle beside it.
struct EdgeUse {
  std::uint32_t low = 0, high = 0, triangle = 0;
};

/// The three edges of every triangle, sorted by edge, then by triangle.
[[nodiscard]] std::vector<EdgeUse> sorted_edges(std::span<const Triangle> triangles, std::size_t vertex_count);

/// The lowest-numbered triangle that is a third one at an edge; nothing for a mesh whose edges are all manifold.
[[nodiscard]] std::optional<std::uint32_t> first_non_manifold_triangle(std::span<const Triangle> triangles,
                                                                       std::size_t vertex_count);

/// The triangles, ascending, without which every edge has two triangles at most: those that repeat an earlier one, in
/// either direction, and at an edge of three and more all but two, which are the flattest pair that runs along the edge
/// in opposite directions (of more than 16 triangles the first such pair). They are sheets of their own, which follow
/// the surface by the vertices that they share with it. Empty for a manifold.
[[nodiscard]] std::vector<std::uint32_t> extra_triangles(std::span<const Triangle> triangles,
                                                         std::span<const ModelPoint> positions);
/// One line about extra triangles, for whoever opened a file. Empty: there are none.
[[nodiscard]] std::string note_of_extra_triangles(const TriangleMesh& mesh);

/// For every vertex the lowest-numbered vertex it is one with. Vertices of one part at exactly the same position are
/// welded where the welded part stays manifold (no edge with three triangles, no triangle that collapses); a part that
/// would not stays unwelded, because there the touching surfaces are separate things (lashes on a lid).
/// Two parts are welded along border edges that they share exactly, in opposite directions, if all of that leaves the
/// mesh manifold: one surface in two materials. `extra` (extra_triangles) have no say in that.
[[nodiscard]] std::vector<std::uint32_t> weld_coincident(const MeshSource& source,
                                                         std::span<const std::uint32_t> extra = {});

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
