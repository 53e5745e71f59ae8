#include "ui/render/normals.h"

#include <glm/geometric.hpp>

namespace penpose::render {

std::vector<glm::vec3> smooth_normals(const mesh::TriangleMesh& mesh, std::span<const glm::vec3> positions) {
  const auto group = mesh.smoothing();
  // Double sums: products of two very small or very large lengths still have room in the exponent.
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3{0});
  for (const mesh::Triangle& t : mesh.triangles()) {
    const glm::dvec3 a{positions[t[0]]};
    const glm::dvec3 n = glm::cross(glm::dvec3{positions[t[1]]} - a, glm::dvec3{positions[t[2]]} - a);
    for (const std::uint32_t v : t) sums[group[v]] += n;
  }
  std::vector<glm::vec3> normals(positions.size());
  for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = glm::vec3(geometry::normalized(sums[group[v]]));
  return normals;
}

std::vector<glm::vec3> to_float(std::span<const geometry::ModelPoint> points) { return {points.begin(), points.end()}; }

}  // namespace penpose::render
