#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "core/rig/blend_shapes.h"
#include "core/rig/character_rig.h"

namespace penpose::tests {

/// A flat grid of (columns + 1) x (rows + 1) vertices over 0..width x 0..height at z = 0, facing +z.
inline std::shared_ptr<const mesh::TriangleMesh> grid_mesh(std::uint32_t columns, std::uint32_t rows, double width = 1,
                                                           double height = 1) {
  mesh::MeshSource source;
  for (std::uint32_t r = 0; r <= rows; ++r) {
    for (std::uint32_t c = 0; c <= columns; ++c)
      source.positions.emplace_back(width * c / columns, height * r / rows, 0.0);
  }
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t i = r * (columns + 1) + c;
      source.triangles.push_back({i, i + 1, i + columns + 2});
      source.triangles.push_back({i, i + columns + 2, i + columns + 1});
    }
  }
  return mesh::TriangleMesh::build(std::move(source)).value();
}

/// Smooth random bumps: shape i moves the vertices around a random centre in a random direction.
inline std::shared_ptr<const rig::BlendShapes> random_shapes(const mesh::TriangleMesh& mesh, std::size_t count,
                                                             std::uint64_t seed, double reach = 0.3,
                                                             double size = 0.2) {
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<rig::BlendShape> shapes;
  for (std::size_t s = 0; s < count; ++s) {
    rig::BlendShape shape;
    shape.parameter.name = "shape" + std::to_string(s);
    const geometry::ModelPoint center = mesh.positions()[random() % mesh.vertex_count()];
    const geometry::ModelVector direction{uniform() - 0.5, uniform() - 0.5, uniform() - 0.5};
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      const double d = geometry::distance(mesh.positions()[v], center) / reach;
      if (d >= 1) continue;
      shape.vertices.push_back(v);
      shape.deltas.emplace_back(direction * (2 * size * (1 - d * d)));
    }
    shapes.push_back(std::move(shape));
  }
  return rig::BlendShapes::make(std::move(shapes), mesh.vertex_count()).value();
}

}  // namespace penpose::tests
