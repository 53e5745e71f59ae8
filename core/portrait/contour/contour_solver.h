#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/intent/choosing/quadratic.h"
#include "core/intent/choosing/selection.h"
#include "core/portrait/contour/contour_controls.h"
#include "core/portrait/contour/contour_match.h"
#include "core/portrait/placement.h"

namespace penpose::portrait {

/// Where a sheet lies in the picture: as it was laid there first, moved a little about the middle of the lines.
class SheetPlace {
 public:
  /// `ease`: times the usual widths.
  SheetPlace(const Placement& first, PxPoint middle, double ease = 1) : first_(first), middle_(middle) {
    for (std::size_t k = 0; k < widths_.size(); ++k) widths_[k] = ease * k_widths[k];
  }
  [[nodiscard]] PxPoint operator()(const PxPoint& p) const;
  [[nodiscard]] Placement placement() const;
  /// How a place of the picture moves with shift to the right (px), down (px), growth (share) and turn (radians).
  [[nodiscard]] std::array<PxPoint, 4> ways(const PxPoint& at) const;
  /// By so many widths of each.
  void move(std::span<const double> by);
  /// Squares of all moves in widths of what is usual.
  [[nodiscard]] double squares() const;
  [[nodiscard]] const std::array<double, 4>& moved() const { return moved_; }
  static constexpr std::array<double, 4> k_widths{3.0, 3.0, 0.004, 0.004};

 private:
  Placement first_;
  PxPoint middle_;
  std::array<double, 4> widths_{};
  std::array<double, 4> moved_{0, 0, 0, 0};  ///< in widths
};

/// A pose by its units, where the sheet lies, and what that leaves of the lines.
struct ContourReading {
  intent::Choice choice;
  SheetPlace sheet{{}, {}, 1};
  std::vector<ContourMatch> matches;  ///< one a line
  double energy = 1e300;
};

/// Poses a rig so that its contours are drawn lines. In each round the contours of the pose so far are found anew and
/// matched with the lines; where they are matched, the surface's points are the references of the next step, across the
/// contour: along it and in depth a contour slides over the surface. Few units move (intent::Selection). Before that,
/// units are tried at several values with the contours that they would have, since lines that moved far lie beside
/// other contours.
class ContourSolver {
 public:
  /// `lines`: of the sheet. All must outlive this.
  ContourSolver(const rig::Rig& rig, const ContourControls& controls, SeenContours& contours,
                std::span<const EvenLine> lines, std::span<const posing::CurvePoint> kept, const rig::Pose& start);

  /// With nothing moved, the sheet laid where the lines are nearest to contours.
  [[nodiscard]] ContourReading still(const SheetPlace& sheet);
  [[nodiscard]] ContourReading solve(const ContourReading& still);

 private:
  /// Finds contours and matches; fills in the energy.
  void measure(ContourReading& reading);
  [[nodiscard]] double costs_of(const intent::Choice& choice);
  /// Fills the quadratic with the matches of a reading. `variables`: with these columns.
  void look(const ContourReading& reading, std::span<const std::size_t> variables);
  void add_rows(const ContourReading& reading);
  void fill_columns(const ContourReading& reading, std::span<const std::size_t> variables);
  /// A run of numbers, one a row, as what the sheet's moves can take of it.
  void slide(std::span<double> column) const;
  /// Lets the sheet give way to what the quadratic leaves at the reading's values.
  void settle_sheet(ContourReading& reading) const;
  /// Rounds with the reading's own units; the best of them.
  [[nodiscard]] ContourReading refined(ContourReading reading, int rounds);
  /// The same with units chosen anew in each.
  [[nodiscard]] ContourReading chosen(ContourReading reading, int rounds);
  /// The best first guesses of one unit more, or of a unit that moves already, one a unit.
  [[nodiscard]] std::vector<ContourReading> explored(const ContourReading& from);
  /// What of the lines lies farther off than a hand strays, in doubt: no unit more gains more than that.
  [[nodiscard]] double standing_out(const ContourReading& reading) const;
  [[nodiscard]] ContourReading pruned(ContourReading reading);

  struct Row {
    posing::CurvePoint point;
    PxPoint way;       ///< the row is its product with how the point moves in the picture
    double right = 0;  ///< what is left to the line
    std::array<double, 4> sheet{0, 0, 0, 0};
  };

  const rig::Rig& rig_;
  const ContourControls& controls_;
  SeenContours& contours_;
  std::span<const EvenLine> lines_;
  std::span<const posing::CurvePoint> kept_;
  std::vector<PxPoint> kept_px_;
  intent::Costs costs_;
  intent::Quadratic quadratic_;
  std::vector<Row> rows_;
  std::array<double, 16> sheet_factor_{};  ///< Cholesky factor of what moves of the sheet do to the rows
};

}  // namespace penpose::portrait
