#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "core/articulation/region/canvas.h"
#include "core/articulation/surface/surface.h"
#include "core/base/result.h"

namespace penpose::articulation {

/// A surface that moved points keep their distance from (surface/held_surface.h), or none. Cheap to copy.
class KeptSurface {
 public:
  /// No surface: `keep` and `lift` change nothing.
  KeptSurface() = default;
  /// Null: no surface.
  explicit KeptSurface(std::shared_ptr<const HeldSurface> held) : held_(std::move(held)) {}
  /// Errors (place "surface/KEY"): those of the surface, such as no part of that name.
  static base::Result<KeptSurface> make(const Surface& surface, const Canvas& canvas);

  [[nodiscard]] bool exists() const { return held_ != nullptr; }
  /// What motions turn about; nothing where they go straight.
  [[nodiscard]] std::optional<ModelPoint> center() const { return held_ ? held_->center() : std::nullopt; }
  /// True for a vertex of the surface itself.
  [[nodiscard]] bool consists_of(std::uint32_t vertex, const ModelPoint& rest) const {
    return held_ && held_->consists_of(vertex, rest);
  }
  /// The distance to keep of a point at rest: from the centre of a ball; signed, from any other surface.
  [[nodiscard]] double level(const ModelPoint& rest) const { return held_ ? held_->level(rest) : 0.0; }
  /// The point moved to a level. `rest` gives the direction when the moved point has none.
  [[nodiscard]] ModelPoint keep(const ModelPoint& moved, const ModelPoint& rest, double level) const {
    return held_ ? held_->keep(moved, rest, level) : moved;
  }
  /// The point of a ray (unit direction) that lies on a level, the one nearest to `near`, the distance along the ray
  /// where the method lifts a target without a surface. Lifted there, a target is where the surface constrains the
  /// curve that reaches it, under the drawn line. `near` itself, or the ray's closest approach to a ball, where the
  /// ray misses the level.
  [[nodiscard]] double lift(const geometry::Ray& ray, double near, double level) const {
    return held_ ? held_->lift(ray, near, level) : near;
  }

 private:
  std::shared_ptr<const HeldSurface> held_;
};

}  // namespace penpose::articulation
