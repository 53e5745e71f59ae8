#include "tests/sketches/surface_check.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

namespace penpose::sketches {
namespace {

using geometry::ModelVector;

struct Normals {
  std::vector<ModelVector> of_triangles;
  std::vector<ModelVector> of_vertices;  ///< by weld, weighted by area
};

Normals normals_of(const articulation::Canvas& canvas, std::span<const ModelPoint> positions,
                   std::span<const std::uint32_t> triangles) {
  Normals normals;
  const auto weld = canvas.mesh().weld();
  normals.of_vertices.assign(positions.size(), ModelVector{0});
  for (const std::uint32_t t : triangles) {
    const auto& [a, b, c] = canvas.mesh().triangles()[t];
    const ModelVector n = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
    normals.of_triangles.push_back(n);
    for (const std::uint32_t v : {a, b, c}) normals.of_vertices[weld[v]] += n;
  }
  return normals;
}

bool runs_against(const articulation::Canvas& canvas, const Normals& normals, std::size_t i, std::uint32_t triangle) {
  ModelVector around{0};
  for (const std::uint32_t v : canvas.mesh().triangles()[triangle]) {
    around += geometry::normalized(normals.of_vertices[canvas.mesh().weld()[v]], {0, 0, 0});
  }
  return glm::dot(around, normals.of_triangles[i]) < 0;
}

}  // namespace

SurfaceCheck check_surface(const articulation::Canvas& canvas, std::span<const ModelPoint> posed,
                           std::span<const std::uint32_t> moved) {
  const auto rest = canvas.positions();
  const auto weld = canvas.mesh().weld();
  // All triangles two rings about what moves, so that every corner has its whole fan.
  std::vector<char> near(rest.size(), 0);
  for (const std::uint32_t v : moved) near[weld[v]] = 1;
  const auto grow = [&] {
    std::vector<char> grown = near;
    for (const auto& t : canvas.mesh().triangles()) {
      if (near[weld[t[0]]] != 0 || near[weld[t[1]]] != 0 || near[weld[t[2]]] != 0) {
        for (const std::uint32_t v : t) grown[weld[v]] = 1;
      }
    }
    near = grown;
  };
  const std::vector<char> core = near;
  grow();
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < canvas.mesh().triangle_count(); ++t) {
    const auto& triangle = canvas.mesh().triangles()[t];
    if (std::any_of(triangle.begin(), triangle.end(), [&](std::uint32_t v) { return near[weld[v]] != 0; })) {
      triangles.push_back(t);
    }
  }
  const Normals before = normals_of(canvas, rest, triangles);
  const Normals after = normals_of(canvas, posed, triangles);
  SurfaceCheck check;
  std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& triangle = canvas.mesh().triangles()[triangles[i]];
    const bool touched =
        std::any_of(triangle.begin(), triangle.end(), [&](std::uint32_t v) { return core[weld[v]] != 0; });
    if (!touched) continue;
    if (runs_against(canvas, after, i, triangles[i]) && !runs_against(canvas, before, i, triangles[i])) {
      ++check.against_neighbours;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k];
      const std::uint32_t b = triangle[(k + 1) % 3];
      edges[{std::min(weld[a], weld[b]), std::max(weld[a], weld[b])}].push_back(i);
      const double was = geometry::distance(rest[a], rest[b]);
      if (!(was > 0)) continue;
      const double ratio = geometry::distance(posed[a], posed[b]) / was;
      check.stretch = std::max(check.stretch, ratio);
      if (ratio > 3 && a < b) ++check.stretched;
    }
  }
  for (const auto& [edge, sides] : edges) {
    if (sides.size() != 2) continue;
    const auto cosine = [&](const Normals& normals) {
      const ModelVector none{0};
      return glm::dot(geometry::normalized(normals.of_triangles[sides[0]], none),
                      geometry::normalized(normals.of_triangles[sides[1]], none));
    };
    if (cosine(after) < -0.5 && cosine(before) > 0) ++check.creases;
  }
  return check;
}

}  // namespace penpose::sketches
