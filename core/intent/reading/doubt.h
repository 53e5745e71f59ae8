#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace penpose::intent {

/// The energy of squares of doubt. How far a rig can follow a line is not known beforehand, so the scale of what is
/// left is found with the reading: a normal error of unknown width, whose least is the hand's, leaves by its likelihood
///
///   E = sum over groups of nu sqrt(L) log(1 + sum of D / (nu L)),   L the number of its curves
///
/// (Student's t; Lange, Little and Taylor, JASA 84, 1989). Curves that lie together are a group with one scale.
class Doubt {
 public:
  /// Adds a group of curves and returns its number.
  std::size_t add_group(double reach);
  /// Adds the next curve. Precondition: the group exists.
  void add_curve(std::size_t group);
  [[nodiscard]] std::size_t group_of(std::size_t curve) const { return group_of_[curve]; }
  /// `squares`: D of each curve, and then of what counts by its squares alone.
  [[nodiscard]] double energy(std::span<const double> squares) const;
  /// What one curve adds to the energy. `squares`: D of the first curves, those of its group among them.
  [[nodiscard]] double added_by(std::size_t curve, std::span<const double> squares) const;
  /// dE/dD of each.
  void weights(std::span<const double> squares, std::vector<double>& out) const;

 private:
  struct Group {
    double count = 0;
    double reach = 0;
  };
  /// Sums of the groups' squares, each over nu L.
  void measure(std::span<const double> squares) const;

  std::vector<Group> groups_;
  std::vector<std::size_t> group_of_;
  mutable std::vector<double> sums_;
};

}  // namespace penpose::intent
