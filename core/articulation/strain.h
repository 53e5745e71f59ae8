#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/articulation/patch.h"

namespace penpose::articulation {

/// What a motion does to the surface of a patch.
struct Strain {
  double energy = 0;       ///< stretch and shear, the mean over the surface: 0 where only turned, see Strainmeter
  double stretch = 1;      ///< the largest ratio of an edge's length to that at rest
  std::uint32_t node = 0;  ///< an end of that edge
  std::size_t turned_over = 0;  ///< triangles that came to face the other way
};
/// The worse of the two in everything; energies add.
[[nodiscard]] Strain worse(const Strain& a, const Strain& b);

/// Measures the distortion of a patch. With s and t the largest and smallest stretch within a triangle its energy is
/// s^2 + t^2 + 1/s^2 + 1/t^2 - 4 (symmetric Dirichlet), the same for a triangle stretched or pressed by one factor; one
/// that is turned over counts as pressed to nothing.
class Strainmeter {
 public:
  explicit Strainmeter(const Patch& patch);

  /// `moves` displaces the nodes; `turns` (axis times angle, or empty) is how far each was meant to turn, so that a
  /// triangle that turns with its limb is not taken for one that is turned over.
  [[nodiscard]] Strain measure(std::span<const ModelVector> moves, std::span<const ModelVector> turns) const;

 private:
  struct Cell {
    double a = 0, b = 0, c = 0;  ///< inverse of its two edges in its own plane: [a b; 0 c]
    double area = 0;
    ModelVector normal{0};
  };
  const Patch& patch_;
  std::vector<Cell> cells_;
  double area_ = 0;
};

}  // namespace penpose::articulation
