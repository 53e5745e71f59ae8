#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/articulation/sketch.h"
#include "core/base/result.h"
#include "core/geometry/closest_point.h"

namespace penpose::articulation {

/// A surface that moved points keep their distance from (method, section 3, "Surface constraint"). Cheap to copy.
class KeptSurface {
 public:
  /// No surface: `keep` and `lift` change nothing.
  KeptSurface() = default;
  /// Errors (place "surface/mesh"): no part of that name, a part without triangles.
  static base::Result<KeptSurface> make(const Surface& surface, const Canvas& canvas);

  [[nodiscard]] bool exists() const { return surface_.index() != 0; }
  /// The ball, if it is one.
  [[nodiscard]] const Sphere* ball() const { return std::get_if<Sphere>(&surface_); }
  /// True for a vertex of the surface itself: of the part, or on or inside the ball (within a thousandth of its
  /// radius).
  [[nodiscard]] bool consists_of(std::uint32_t vertex, const ModelPoint& rest) const;
  /// The distance that a point at rest keeps: from the centre of a ball; signed, from any other surface.
  [[nodiscard]] double level(const ModelPoint& rest) const;
  /// The point moved to a level: along the ray from the centre of a ball; along the surface normal of the closest point
  /// of any other surface, where a point off the surface takes the direction to its closest point for that normal (at
  /// an edge there is a fan of them), so that the distance is kept exactly on the convex side. `rest` gives the
  /// direction when the moved point has none.
  [[nodiscard]] ModelPoint keep(const ModelPoint& moved, const ModelPoint& rest, double level) const;
  /// The point of a ray (unit direction) that lies on a level, the one nearest to `near`, the distance along the ray
  /// where the method lifts a target without a surface. Lifted there, a target is where the surface constrains the
  /// curve that reaches it, under the drawn line. `near` itself, or the ray's closest approach to a ball, where the
  /// ray misses the level.
  [[nodiscard]] double lift(const geometry::Ray& ray, double near, double level) const;

 private:
  struct Part {
    geometry::ClosestPointTree tree;
    double size;
    std::vector<std::array<std::uint32_t, 2>> vertices;  ///< runs [first, end) of the mesh
  };
  std::variant<std::monostate, Sphere, std::shared_ptr<const Part>> surface_;
};

}  // namespace penpose::articulation
