#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/articulation/surface/held_surface.h"
#include "core/articulation/surface/symmetry_plane.h"
#include "core/base/members.h"
#include "core/base/result.h"

namespace penpose::articulation {

/// A part of the model that vertices keep their distance from, by its name.
struct PartSurface {
  static constexpr std::string_view k_name = "part";
  static constexpr std::string_view k_key = "mesh";
  static constexpr std::string_view k_form = R"({"mesh": NAME})";
  static constexpr bool k_of_region = false;
  std::string part;
  static auto members(auto& self) { return base::named("part", self.part); }
  friend bool operator==(const PartSurface&, const PartSurface&) = default;

  [[nodiscard]] static base::Status check() { return base::Done{}; }
  /// The part of the mirrored name; one whose name has no side, such as a skull, is its own mirror image.
  [[nodiscard]] PartSurface mirrored(const SymmetryPlane& plane) const;
  /// Errors (place "surface/mesh"): no part of that name, a part without triangles.
  [[nodiscard]] base::Result<std::shared_ptr<const HeldSurface>> held(const Canvas& canvas) const;
  [[nodiscard]] std::string words() const { return part; }
  [[nodiscard]] static std::vector<OfferedSurface<PartSurface>> offered(const mesh::TriangleMesh& mesh,
                                                                        const RegionPoints& region);
};

}  // namespace penpose::articulation
