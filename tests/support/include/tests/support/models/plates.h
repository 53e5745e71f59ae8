#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/curve/sheet_line.h"
#include "core/curve/sheets.h"
#include "core/geometry/bvh.h"
#include "core/geometry/camera.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::tests {

/// A rectangle that faces the viewer, who looks down z.
inline void add_plate(mesh::MeshSource& source, double from_x, double to_x, double from_y, double to_y, double z) {
  const auto first = static_cast<std::uint32_t>(source.positions.size());
  for (const auto& [x, y] : {std::array{from_x, from_y}, {to_x, from_y}, {to_x, to_y}, {from_x, to_y}})
    source.positions.emplace_back(x, y, z);
  source.triangles.push_back({first, first + 1, first + 2});
  source.triangles.push_back({first, first + 2, first + 3});
}

/// A mesh of plates for drawing lines on: 1 unit is 500 px; (0, 0) is at px (250, 750); the camera looks down z from
/// z = 1.
struct Look {
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::vector<glm::vec3> positions;
  geometry::TriangleBvh tree;
  curve::Sheets sheets;
  geometry::Camera camera = geometry::Camera::make({{0.5, 0.5, 1}, {0.5, 0.5, 0}, {0, 1, 0}, 90}, {1000, 1000}).value();

  explicit Look(std::shared_ptr<const mesh::TriangleMesh> m)
      : mesh(std::move(m)),
        positions(mesh->positions().begin(), mesh->positions().end()),
        tree(positions, mesh->triangles()),
        sheets(*mesh) {}
  [[nodiscard]] curve::SheetSurface surface() { return {tree, positions, mesh->triangles(), sheets}; }
};

}  // namespace penpose::tests
