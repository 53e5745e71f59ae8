#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/articulation/region/patch.h"
#include "core/geometry/camera.h"
#include "core/geometry/lasso.h"

namespace penpose::articulation {

/// The regions drawn on a patch.
struct DrawnRegions {
  const geometry::Camera& camera;  ///< of both
  const geometry::Lasso& general;
  const geometry::Lasso& specific;
};

/// Weights that fall off over the surface: 1 at the nodes of the core, 0 outside of the region, between them g/(g + c)
/// with g the distance over the surface to the region's border and c to the core's. Both borders run through triangles
/// where the pen crossed them. A free end of the surface is no border: the tip of an ear inside the lasso moves as much
/// as the part below it.
class Falloff {
 public:
  Falloff(const Patch& patch, const DrawnRegions& drawn);

  /// Nodes of the patch that lie inside the region of specific interest; 1 a node.
  [[nodiscard]] std::span<const std::uint8_t> specific() const { return specific_; }
  /// Where the region of specific interest extends beyond that of general interest on the model, as seen from the
  /// middle of its part inside ("on its left"); empty where it does not.
  [[nodiscard]] const std::string& reaches_beyond() const { return reaches_beyond_; }
  /// The weight of every node when all of the region of specific interest is the core.
  [[nodiscard]] std::vector<double> weights() const;
  /// The depth of every node of the region of specific interest: its distance over the surface to the border.
  [[nodiscard]] std::vector<double> inward() const;
  /// The same with a smaller core: `depth` 0..1 of the way from the border of the region of specific interest to the
  /// curve belongs to the falloff, where `to_curve` is the distance of every node to the curve and `inward` as above.
  [[nodiscard]] std::vector<double> weights(double depth, std::span<const double> inward,
                                            std::span<const double> to_curve) const;

 private:
  void find_beyond(const DrawnRegions& drawn, std::span<const geometry::PxPoint> seen);
  [[nodiscard]] std::vector<double> blended(std::span<const double> to_core, std::span<const std::uint8_t> core) const;

  const Patch& patch_;
  std::vector<std::uint8_t> inner_;
  std::vector<std::uint8_t> specific_;
  std::string reaches_beyond_;
  std::vector<double> to_border_;
  std::vector<double> to_specific_;
};

}  // namespace penpose::articulation
