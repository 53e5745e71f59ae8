#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace penpose::mesh {

/// The area vector of the triangles around each vertex, as few cross products: the fan around a vertex spans a closed
/// polygon, whose area vector does not depend on how it is cut, so it is cut into quadrilaterals, each the cross
/// product of its diagonals: sum over the quads (a, b, c, d) of (c - a) x (d - b). A triangle is a quad with c = d. The
/// result is that of summing the area vectors of all triangles, i.e. an area-weighted vertex normal (Gouraud 1971), at
/// about a third of the work.
class VertexRings {
 public:
  using Quad = std::array<std::uint32_t, 4>;

  explicit VertexRings(const TriangleMesh& mesh);

  /// Quads of the smoothing group of a vertex; empty for a vertex that follows another one (see leader) or has no
  /// triangle.
  [[nodiscard]] std::span<const Quad> quads(std::uint32_t vertex) const {
    return std::span(quads_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }
  /// The vertex whose normal this vertex shares; itself in most cases.
  [[nodiscard]] std::uint32_t leader(std::uint32_t vertex) const { return leader_[vertex]; }
  [[nodiscard]] std::size_t vertex_count() const { return leader_.size(); }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<Quad> quads_;
  std::vector<std::uint32_t> leader_;
};

}  // namespace penpose::mesh
