#include "core/io/surface/normals.h"

#include <glm/geometric.hpp>
#include <numeric>

#include "core/geometry/space.h"

namespace penpose::io {

std::vector<glm::vec3> smooth_normals(std::span<const mesh::ModelPoint> positions,
                                      std::span<const mesh::Triangle> triangles,
                                      std::span<const std::uint32_t> groups) {
  std::vector<geometry::ModelVector> sums(positions.size(), geometry::ModelVector{0});
  for (const mesh::Triangle& t : triangles) {
    const auto area = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    for (const std::uint32_t v : t) sums[groups[v]] += area;
  }
  std::vector<glm::vec3> normals(positions.size());
  for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = glm::vec3(geometry::normalized(sums[groups[v]]));
  return normals;
}

void fill_missing_normals(mesh::MeshSource& source) {
  bool missing = false;
  for (glm::vec3& n : source.normals) {
    const geometry::ModelVector unit = geometry::normalized(geometry::ModelVector(n), geometry::ModelVector(0));
    n = glm::vec3(unit);
    missing = missing || n == glm::vec3(0);
  }
  if (!missing) return;
  std::vector<std::uint32_t> alone(source.positions.size());
  std::iota(alone.begin(), alone.end(), 0U);
  const auto smooth = smooth_normals(source.positions, source.triangles, alone);
  for (std::size_t v = 0; v < smooth.size(); ++v) {
    if (source.normals[v] == glm::vec3(0)) source.normals[v] = smooth[v];
  }
}

}  // namespace penpose::io
