#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/mesh/triangle_mesh.h"

namespace penpose::mesh {

/// A point glued to the surface: it follows the mesh when the mesh deforms. The barycentric coordinates belong to the
/// corners of the triangle in order and sum to one.
struct MeshPoint {
  std::uint32_t triangle = 0;
  std::array<double, 3> barycentric{1, 0, 0};
  friend bool operator==(const MeshPoint&, const MeshPoint&) = default;
};

/// Where the point is when the vertices are at `positions`. Precondition: the triangle exists.
[[nodiscard]] ModelPoint position_of(const MeshPoint& point, std::span<const Triangle> triangles,
                                     std::span<const ModelPoint> positions);

/// A vertex as a point of a triangle that has it. Nothing: none has.
[[nodiscard]] std::optional<MeshPoint> mesh_point_at(std::uint32_t vertex, std::span<const Triangle> triangles);

}  // namespace penpose::mesh
