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

/// Nothing, also where it lies on a ball.
struct Free {
  static constexpr std::string_view k_name = "free";
  static constexpr std::string_view k_key = "free";
  static constexpr std::string_view k_form = R"({"free": {}})";
  static constexpr bool k_of_region = false;
  static auto members(auto& /*self*/) { return base::named(); }
  friend bool operator==(const Free&, const Free&) = default;

  [[nodiscard]] static base::Status check() { return base::Done{}; }
  [[nodiscard]] static Free mirrored(const SymmetryPlane& /*plane*/) { return {}; }
  [[nodiscard]] static base::Result<std::shared_ptr<const HeldSurface>> held(const Canvas& /*canvas*/) {
    return std::shared_ptr<const HeldSurface>();
  }
  [[nodiscard]] static std::string words() { return "nothing"; }
  [[nodiscard]] static std::vector<OfferedSurface<Free>> offered(const mesh::TriangleMesh& /*mesh*/,
                                                                 const RegionPoints& /*region*/) {
    return {{"nothing", "Straight, also where it lies on a ball", [] { return Free{}; }, ""}};
  }
};

}  // namespace penpose::articulation
