#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace penpose::inference {

/// The terms of a reading's energy. The energy is the sum of all terms, each times its weight. Terms have no dimension,
/// so they mean the same on any rig. All but `taught` are at least 0.
enum class Term : std::uint8_t {
  evidence,   ///< what the pose leaves of the lines, as -log of its likelihood (Student's t)
  unit,       ///< units that move
  elsewhere,  ///< log(1 + what a unit moves elsewhere over what it moves near the lines, both squared)
  distant,    ///< log(1 + (largest way far from the lines over the largest near them) squared)
  mirrored,  ///< log(1 + what a unit moves at the mirror image of the lines over what it moves near them, both squared)
  turned,    ///< log(1 + (how much a unit turns a piece of the mesh without lines, as gaze does an eyeball, over its
             ///< largest way near the lines) squared)
  scattered,  ///< log(1 + (largest way of what a unit moves elsewhere, apart from what it moves near the lines, over
              ///< its largest way near them) squared): an expression moves several places
  lone,       ///< units of a control that has no counterpart on the other side
  faint,      ///< log(usual way of the control that moves most / a unit's own)
  bears,      ///< of joints: the share of what shapes do that happens on what the joint carries, squared
  carried,    ///< of joints: elsewhere beyond what any joint carries
  axis,       ///< axes about which joints turn
  part,       ///< parts beyond the first of a control that is the sum of others
  crosses,    ///< how deep a control drives lips through each other, 0 to 1
  lopsided,   ///< how much a unit does on one side of what the lines ask for on both, 0 to 1
  against,    ///< cosine of two units' fields beyond a tenth against each other
  helper,     ///< how much a unit moves what another one moves already, 0 to 1
  share,      ///< squares of the controls' shares of their ranges
  tie,        ///< squares of the differences between the sides of a pair
  nothing,    ///< decades by which a line that moves nothing asks for more than a hand strays
  backwards,  ///< lines read from their other end, where both are possible
  partial,    ///< lines that are read as a part of their curve
  left_out,   ///< the shares of curves that are left out so
  overshot,   ///< lines that are read as longer than their curve
  one_end,    ///< by how much they are longer at one end alone
  taught,     ///< what the artist's choices on this rig taught of a unit; below 0 where it is meant more often
  leaning,    ///< joints that lean as joints rarely do
};
inline constexpr std::size_t k_term_count = static_cast<std::size_t>(Term::leaning) + 1;

/// A number for each term.
class Terms {
 public:
  [[nodiscard]] double& operator[](Term term) { return values_[static_cast<std::size_t>(term)]; }
  [[nodiscard]] double operator[](Term term) const { return values_[static_cast<std::size_t>(term)]; }
  [[nodiscard]] std::span<const double, k_term_count> values() const { return values_; }
  [[nodiscard]] std::span<double, k_term_count> values() { return values_; }

  Terms& operator+=(const Terms& other) {
    for (std::size_t k = 0; k < k_term_count; ++k) values_[k] += other.values_[k];
    return *this;
  }
  [[nodiscard]] double dot(const Terms& other) const {
    double sum = 0;
    for (std::size_t k = 0; k < k_term_count; ++k) sum += values_[k] * other.values_[k];
    return sum;
  }

 private:
  std::array<double, k_term_count> values_{};
};

/// Returns the enumerator's name, for tables.
[[nodiscard]] const char* name_of(Term term);

}  // namespace penpose::inference
