#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/space.h"

namespace penpose::mesh {

using geometry::ModelPoint;
using Triangle = std::array<std::uint32_t, 3>;

/// A run of vertices and triangles that came from one mesh primitive of a file. Vertex v of the file's primitive is
/// vertex first_vertex + v of the mesh, whatever is welded inside.
struct Part {
  std::string name;
  std::uint32_t first_vertex = 0;
  std::uint32_t vertex_count = 0;
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
};

/// What a mesh is built from. All arrays in the file's order.
struct MeshSource {
  std::vector<ModelPoint> positions;  ///< rest positions; rounded to float, the precision of glTF
  std::vector<glm::vec3> normals;     ///< one a vertex, or empty where the file has none
  std::vector<Triangle> triangles;    ///< counter-clockwise from outside
  std::vector<Part> parts;            ///< in order, covering all; empty: one part without a name
};

/// An immutable triangle mesh: rest positions, triangles and what follows from them. Made by `build`.
class TriangleMesh {
 public:
  /// Validates and builds. Errors (place "vertex N" or "triangle N"): no vertices, a position that is not finite, an
  /// index out of range, parts that do not cover the mesh. Triangles that repeat a vertex are dropped; edges may have
  /// more than two (extra_triangles in topology.h).
  static base::Result<std::shared_ptr<const TriangleMesh>> build(MeshSource source);

  [[nodiscard]] std::span<const ModelPoint> positions() const { return source_.positions; }
  [[nodiscard]] std::span<const glm::vec3> file_normals() const { return source_.normals; }
  [[nodiscard]] std::span<const Triangle> triangles() const { return source_.triangles; }
  [[nodiscard]] std::span<const Part> parts() const { return source_.parts; }
  [[nodiscard]] std::size_t vertex_count() const { return source_.positions.size(); }
  [[nodiscard]] std::size_t triangle_count() const { return source_.triangles.size(); }
  [[nodiscard]] std::size_t dropped_triangles() const { return dropped_triangles_; }
  [[nodiscard]] const geometry::Box& rest_box() const { return rest_box_; }

  /// For every vertex the lowest-numbered vertex that it is one with: coincident vertices of a part are welded where
  /// that leaves the part manifold, and parts along borders that they share; else every vertex stands for itself.
  [[nodiscard]] std::span<const std::uint32_t> weld() const { return weld_; }
  /// For every vertex the number of its connected component (after welding), 0.. in order of their lowest vertex.
  [[nodiscard]] std::span<const std::uint32_t> components() const { return components_; }
  [[nodiscard]] std::size_t component_count() const { return component_count_; }
  /// For every vertex the lowest-numbered vertex with which it shares a smooth normal (welded, and equal normals in the
  /// file).
  [[nodiscard]] std::span<const std::uint32_t> smoothing() const { return smoothing_; }

  /// The part of that name.
  [[nodiscard]] const Part* find_part(std::string_view name) const;

 private:
  MeshSource source_;
  geometry::Box rest_box_;
  std::vector<std::uint32_t> weld_;
  std::vector<std::uint32_t> components_;
  std::vector<std::uint32_t> smoothing_;
  std::size_t component_count_ = 0;
  std::size_t dropped_triangles_ = 0;
};

}  // namespace penpose::mesh
