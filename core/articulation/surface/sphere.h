#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/articulation/surface/held_surface.h"
#include "core/articulation/surface/symmetry_plane.h"
#include "core/base/members.h"
#include "core/base/result.h"

namespace penpose::articulation {

/// A ball that vertices keep their distance from, in world space at rest.
struct Sphere {
  static constexpr std::string_view k_name = "sphere";
  static constexpr std::string_view k_key = "sphere";
  static constexpr std::string_view k_form = R"({"sphere": {"center", "radius"}})";
  static constexpr bool k_of_region = true;  ///< fitted to one region and none for the next
  ModelPoint center{0};
  double radius = 1;  ///< > 0; vertices inside belong to the ball, every other keeps its own distance from the centre
  static auto members(auto& self) { return base::named("center", self.center, "radius", self.radius); }
  friend bool operator==(const Sphere&, const Sphere&) = default;

  /// A ball that points lie around: its middle is that of the sphere which fits them best (least squares of
  /// |p|² + a·p + b), its radius a little less than the nearest point, so that no point belongs to the ball itself.
  /// Nothing for fewer than four points, or points on a plane.
  [[nodiscard]] static std::optional<Sphere> fitted(std::span<const ModelPoint> points);

  [[nodiscard]] base::Status check() const;
  [[nodiscard]] Sphere mirrored(const SymmetryPlane& plane) const { return {reflected(center, plane), radius}; }
  [[nodiscard]] base::Result<std::shared_ptr<const HeldSurface>> held(const Canvas& canvas) const;
  [[nodiscard]] static std::string words() { return "a ball"; }
  [[nodiscard]] static std::vector<OfferedSurface<Sphere>> offered(const mesh::TriangleMesh& mesh,
                                                                   const RegionPoints& region);
};

}  // namespace penpose::articulation
