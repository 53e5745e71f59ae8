#include "core/portrait/surface/ray_walk.h"

#include <cmath>

#include "core/base/math.h"

namespace penpose::portrait {

std::optional<SurfacePlace> place_at(const FaceSurface& surface, double x, double y) {
  const int column = static_cast<int>(std::lround(x));
  const int row = static_cast<int>(std::lround(y));
  if (!surface.shows_skin(column, row)) return std::nullopt;
  const std::uint32_t number = surface.image().triangle(column, row);
  const mesh::Triangle& t = surface.mesh().triangles()[number];
  const auto places = surface.places();
  const mesh::MeshPoint point{number,
                              seen_barycentric(surface.image().place(x, y), places[t[0]], places[t[1]], places[t[2]])};
  return SurfacePlace{point, surface.position(point)};
}

std::vector<double> turns_of(const std::vector<std::optional<SurfacePlace>>& walk, std::size_t chord) {
  std::vector<double> turns(walk.size(), 0.0);
  for (std::size_t i = chord; i + chord < walk.size(); ++i) {
    if (!walk[i] || !walk[i - chord] || !walk[i + chord]) continue;
    const ModelVector before = walk[i]->place - walk[i - chord]->place;
    const ModelVector after = walk[i + chord]->place - walk[i]->place;
    const double run_before = std::sqrt(before.x * before.x + before.y * before.y);
    const double run_after = std::sqrt(after.x * after.x + after.y * after.y);
    turns[i] = base::atan2(before.z, run_before) - base::atan2(after.z, run_after);
  }
  return turns;
}

std::size_t part_of(const mesh::TriangleMesh& mesh, std::uint32_t triangle) {
  std::size_t part = 0;
  while (part + 1 < mesh.parts().size() && triangle >= mesh.parts()[part + 1].first_triangle) ++part;
  return part;
}

}  // namespace penpose::portrait
