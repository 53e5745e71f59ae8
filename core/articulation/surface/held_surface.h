#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/interface.h"
#include "core/geometry/space.h"

// The interface that every kind of surface implements (surface.h).

namespace penpose::mesh {
class TriangleMesh;
}

namespace penpose::articulation {

class Canvas;
using geometry::ModelPoint;
using geometry::ModelVector;

/// A surface of one model that moved points keep their distance from (method, section 3, "Surface constraint").
class HeldSurface : public base::Interface {
 public:
  /// True for a vertex of the surface itself.
  [[nodiscard]] virtual bool consists_of(std::uint32_t vertex, const ModelPoint& rest) const = 0;
  /// The distance to keep of a point at rest.
  [[nodiscard]] virtual double level(const ModelPoint& rest) const = 0;
  /// The moved point, brought to a level. Where it has no direction of its own, `rest` gives it.
  [[nodiscard]] virtual ModelPoint keep(const ModelPoint& moved, const ModelPoint& rest, double level) const = 0;
  /// Where a ray (unit direction) comes to a level, nearest to `near`, a distance along the ray.
  [[nodiscard]] virtual double lift(const geometry::Ray& ray, double near, double level) const = 0;
  /// What motions over the surface turn about (motion/slide.h); nothing where they go straight.
  [[nodiscard]] virtual std::optional<ModelPoint> center() const { return std::nullopt; }
};

/// The points of the region that a deformer moves, in world space at rest; none before it is drawn.
using RegionPoints = std::function<std::vector<ModelPoint>()>;

/// A surface to choose.
template <typename Kind>
struct OfferedSurface {
  std::string words;
  std::string tip;
  std::function<std::optional<Kind>()> make;
  std::string unable;  ///< what is said where `make` gives none
};

}  // namespace penpose::articulation
