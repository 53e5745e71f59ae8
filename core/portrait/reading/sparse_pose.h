#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/portrait/face_view.h"
#include "core/portrait/reading/likeness.h"

namespace penpose::portrait {

/// E(w) = w'Aw - 2 b'w + c: squares of doubt that lines leave, of the shares of all controls. Few numbers of A are ever
/// asked for, so that each is made when it is. It reads what the LineSystem keeps until its next bend().
struct SquaresOfDoubt {
  /// What one line, or a curve that stays where it is, adds to A.
  struct Part {
    const double* columns;  ///< rows of k_numbers, one a control
    const double* slid;     ///< rows of `slides`, one a control
    double weight;
  };
  std::vector<Part> parts;
  std::size_t slides = 0;
  std::vector<double> nuisances;  ///< rows of `width` numbers, whose products are taken off A
  std::size_t width = 0;          ///< controls, and the lines
  std::vector<double> pull;       ///< b
  double constant = 0;            ///< c

  /// A number of A.
  [[nodiscard]] double curvature(std::size_t i, std::size_t j) const;
};

/// Few controls that explain lines.
struct SparsePose {
  std::vector<std::size_t> units;  ///< ascending
  std::vector<double> shares;      ///< one a control
  double squares = 0;              ///< E
  double energy = 0;               ///< what is minimised
};

/// Chooses units and their shares. The width of what lines leave is not known beforehand, for a rig follows a drawing
/// only so far; so the energy is nu log(1 + E / nu), the likelihood of normal errors of unknown width (Student's t),
/// and each unit that moves adds its cost. Adds, removes and exchanges units, one at a time, while that lowers the
/// energy; the shares are least squares within ranges.
class SparseSolver {
 public:
  explicit SparseSolver(const FaceView& face);

  /// `from`: units to begin with.
  [[nodiscard]] SparsePose solve(const SquaresOfDoubt& squares, std::span<const std::size_t> from);
  /// The energy of these units alone, which bounds that of solve() from above.
  [[nodiscard]] double energy_with(const SquaresOfDoubt& squares, std::span<const std::size_t> units);
  /// nu log(1 + E / nu).
  [[nodiscard]] static double energy_of(double squares);
  /// With nothing moved.
  [[nodiscard]] SparsePose still(const SquaresOfDoubt& squares) const;

 private:
  struct Trial {
    std::vector<std::size_t> units;
    std::vector<double> values;
    double squares = 0;
    double energy = 0;
  };
  /// Of two units; made once a set_up().
  [[nodiscard]] double curvature(std::size_t a, std::size_t b);
  void set_up(const SquaresOfDoubt& squares, std::span<const std::size_t> only);
  [[nodiscard]] Trial fit(std::vector<std::size_t> units);
  /// Units that promise most beside a trial, the best first.
  [[nodiscard]] std::vector<std::size_t> promising(const Trial& trial, std::size_t count);

  const FaceView& face_;
  std::size_t count_ = 0;
  std::vector<std::size_t> all_;             ///< 0, 1, 2, ... one a unit
  std::vector<double> low_, high_, costs_;   ///< one a unit
  const SquaresOfDoubt* squares_ = nullptr;  ///< of the last set_up()
  std::vector<double> curvature_, pull_;     ///< of units; not a number: not made yet
  double constant_ = 0;
};

}  // namespace penpose::portrait
