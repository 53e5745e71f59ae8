#include "core/articulation/surface/part_surface.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/articulation/mirror.h"
#include "core/articulation/region/canvas.h"
#include "core/geometry/closest_point.h"

namespace penpose::articulation {
namespace {

class HeldPart : public HeldSurface {
 public:
  /// Runs [first, end) of the mesh's vertices.
  using Runs = std::vector<std::array<std::uint32_t, 2>>;

  HeldPart(geometry::ClosestPointTree tree, double size, Runs vertices)
      : tree_(std::move(tree)), size_(size), vertices_(std::move(vertices)) {}

  [[nodiscard]] bool consists_of(std::uint32_t vertex, const ModelPoint& /*rest*/) const override {
    for (const auto& [first, end] : vertices_) {
      if (vertex >= first && vertex < end) return true;
    }
    return false;
  }
  /// Signed.
  [[nodiscard]] double level(const ModelPoint& rest) const override { return tree_.signed_distance(rest); }
  /// Along the surface normal of the closest point, where a point off the surface takes the direction to its closest
  /// point for that normal (at an edge there is a fan of them), so that the distance is kept exactly on the convex
  /// side.
  [[nodiscard]] ModelPoint keep(const ModelPoint& moved, const ModelPoint& /*rest*/, double level) const override {
    const geometry::ClosestPoint at = tree_.closest(moved);
    const ModelVector off = moved - at.point;
    // Nearer than this the difference is rounding and has no direction.
    if (at.distance <= 1e-9 * size_) return at.point + at.normal * level;
    const double side = glm::dot(off, at.normal) < 0.0 ? -1.0 : 1.0;
    return at.point + off * (side * level / at.distance);
  }
  /// Newton's method on the signed distance along the ray.
  [[nodiscard]] double lift(const geometry::Ray& ray, double near, double level) const override {
    constexpr int k_steps = 40;
    double t = near;
    for (int i = 0; i < k_steps; ++i) {
      const ModelPoint p = ray.origin + ray.direction * t;
      const geometry::ClosestPoint at = tree_.closest(p);
      const double side = glm::dot(p - at.point, at.normal) < 0.0 ? -1.0 : 1.0;
      const double error = side * at.distance - level;
      if (std::abs(error) <= 1e-12 * size_) return t > 0.0 ? t : near;
      const ModelVector away = geometry::normalized((p - at.point) * side, at.normal);
      const double slope = glm::dot(away, ray.direction);
      if (std::abs(slope) < 0.05) return near;  // along the surface: no clear crossing
      t -= error / slope;
      if (!(std::abs(t - near) <= size_)) return near;
    }
    return near;
  }

 private:
  geometry::ClosestPointTree tree_;
  double size_;
  Runs vertices_;
};

}  // namespace

PartSurface PartSurface::mirrored(const SymmetryPlane& /*plane*/) const {
  const std::string other = mirrored_name(part);
  return {other == part + "_mirrored" ? part : other};
}

base::Result<std::shared_ptr<const HeldSurface>> PartSurface::held(const Canvas& canvas) const {
  const auto weld = canvas.mesh().weld();
  std::vector<mesh::Triangle> triangles;
  geometry::Box box;
  HeldPart::Runs vertices;
  for (const mesh::Part& one : canvas.mesh().parts()) {
    if (one.name != part) continue;
    vertices.push_back({one.first_vertex, one.first_vertex + one.vertex_count});
    for (const mesh::Triangle& t : canvas.mesh().triangles().subspan(one.first_triangle, one.triangle_count)) {
      triangles.push_back({weld[t[0]], weld[t[1]], weld[t[2]]});
      for (const std::uint32_t v : t) box.add(canvas.positions()[v]);
    }
  }
  if (vertices.empty()) {
    std::string names;
    for (const mesh::Part& one : canvas.mesh().parts()) names += (names.empty() ? "" : ", ") + one.name;
    return base::Error{"the model has no part '" + part + "'", "surface/mesh", "its parts are: " + names};
  }
  if (triangles.empty()) {
    return base::Error{"the part '" + part + "' has no triangles", "surface/mesh", "name another part"};
  }
  return std::shared_ptr<const HeldSurface>(std::make_shared<const HeldPart>(
      geometry::ClosestPointTree(canvas.positions(), triangles), box.diagonal(), std::move(vertices)));
}

std::vector<OfferedSurface<PartSurface>> PartSurface::offered(const mesh::TriangleMesh& mesh,
                                                              const RegionPoints& /*region*/) {
  std::vector<OfferedSurface<PartSurface>> parts;
  for (const mesh::Part& one : mesh.parts()) {
    if (!one.name.empty()) parts.push_back({one.name, "", [name = one.name] { return PartSurface{name}; }, ""});
  }
  return parts;
}

}  // namespace penpose::articulation
