#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh_point.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::curve {

using geometry::ModelPoint;

/// Adjacency of triangles over welded edges, to tell whether two places are on one sheet of the surface: the upper
/// and the lower lip are close in space but far apart along the surface.
class Sheets {
 public:
  explicit Sheets(const mesh::TriangleMesh& mesh);
  /// For some triangles of a mesh, numbered in the order given.
  Sheets(const mesh::TriangleMesh& mesh, std::span<const mesh::Triangle> triangles);

  struct Place {
    std::uint32_t triangle = 0;
    ModelPoint position;
  };
  /// Whether a path over the surface leads from one place to the other and stays within `reach` of the straight line
  /// between them. After 4000 triangles the straight distance decides. `positions`: of all vertices as posed.
  [[nodiscard]] bool joined(const Place& a, const Place& b, double reach, std::span<const glm::vec3> positions);

  /// The connected component of a triangle (TriangleMesh::components).
  [[nodiscard]] std::uint32_t component(std::uint32_t triangle) const { return component_[triangle]; }
  /// The area of that component at rest, model units squared.
  [[nodiscard]] double area(std::uint32_t triangle) const { return areas_[component_[triangle]]; }
  /// The area of the largest component.
  [[nodiscard]] double largest_area() const { return largest_area_; }

 private:
  static constexpr std::uint32_t k_border = 0xffffffffU;
  static constexpr std::size_t k_most_visited = 4000;  ///< triangles that a search visits
  std::vector<mesh::Triangle> triangles_;
  std::vector<std::array<std::uint32_t, 3>> beside_;  ///< neighbours over the edge after corner k
  std::vector<std::uint32_t> component_;
  std::vector<double> areas_;  ///< one a component
  double largest_area_ = 0;
  std::vector<std::uint32_t> seen_;  ///< the last search that reached each triangle
  std::vector<std::uint32_t> queue_;
  std::uint32_t search_ = 0;
};

/// The shortest distance between two segments, both of any length.
[[nodiscard]] double segment_distance(const ModelPoint& a0, const ModelPoint& a1, const ModelPoint& b0,
                                      const ModelPoint& b1);

}  // namespace penpose::curve
