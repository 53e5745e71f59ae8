#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/articulation/region/patch.h"

namespace penpose::articulation {

/// The strain of a patch's surface under a motion.
struct Strain {
  double energy = 0;            ///< stretch and shear, the mean over the surface; see Strainmeter
  double stretch = 1;           ///< the largest ratio of an edge's length to that at rest
  std::uint32_t node = 0;       ///< an end of that edge
  std::size_t turned_over = 0;  ///< triangles that face against the surface around them, but not at rest
  std::size_t creased = 0;      ///< edges at which two triangles lie on each other, but not at rest
};
/// The worse of the two in each member; energies add.
[[nodiscard]] Strain worse(const Strain& a, const Strain& b);

/// Measures the distortion of a patch. With s and t the largest and smallest stretch within a triangle its energy is
/// s^2 + t^2 + 1/s^2 + 1/t^2 - 4 (symmetric Dirichlet): 0 where the surface only rotates, the same for a triangle
/// stretched or compressed by one factor; one that is turned over counts as compressed to nothing.
class Strainmeter {
 public:
  explicit Strainmeter(const Patch& patch);

  /// `moves` displaces the nodes. Where few of them changed since the last call, only the cells around those are
  /// measured again; the result is the same to the bit.
  [[nodiscard]] Strain measure(std::span<const ModelVector> moves);
  /// After `measure`: marks (1) the nodes of triangles that are turned over or folded onto each other.
  void mark_torn(std::span<std::uint8_t> nodes) const;

 private:
  struct Cell {
    double a = 0, b = 0, c = 0;  ///< inverse of its two edges in its own plane: [a b; 0 c]
    double area = 0;
    double limit = 0;  ///< of `uprightness`, below which it counts as turned over
  };
  /// An edge and its triangles, which at rest meet at less than a right angle.
  struct Hinge {
    std::uint32_t first = 0, second = 0;
  };
  /// The contribution of a cell to the strain.
  struct Share {
    double energy = 0;
    double bound = 0;  ///< of the square of its edges' stretch
  };
  /// The square of the ratio of an edge's length to that at rest.
  [[nodiscard]] double squared_stretch(std::uint32_t a, std::uint32_t b) const;
  void find_hinges();
  void find_hinges_about();
  [[nodiscard]] bool folded(const Hinge& hinge) const;
  void find_normals();
  void find_normal(std::size_t triangle);
  void find_all();
  /// Measures again what `moved_` nodes changed.
  void find_about_moved();
  void find_share(std::size_t cell);
  [[nodiscard]] Strain sum() const;
  /// How far a triangle faces like the surface around it: 3 where that is flat, below 0 where it is turned over.
  [[nodiscard]] double uprightness(std::size_t triangle) const;

  const Patch& patch_;
  std::vector<Cell> cells_;
  double area_ = 0;
  std::vector<ModelPoint> places_;
  std::vector<ModelVector> normals_;       ///< of triangles, as long as twice their area
  std::vector<ModelVector> node_normals_;  ///< unit, of the triangles around
  std::vector<std::uint8_t> over_;
  std::vector<Share> shares_;
  std::vector<Hinge> hinges_;
  std::vector<std::uint8_t> folded_;  ///< one a hinge
  bool measured_ = false;
  // Surroundings of moved nodes: the hinges of every triangle, and lists that are kept for their memory.
  std::vector<std::uint32_t> hinges_about_, hinge_begins_;
  std::vector<std::uint32_t> moved_, triangles_moved_, nodes_about_, cells_about_;
  std::vector<std::uint8_t> triangle_seen_, node_seen_, hinge_seen_;
};

}  // namespace penpose::articulation
