#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "core/portrait/placement.h"
#include "core/portrait/reading/assignment.h"
#include "core/portrait/reading/likeness.h"
#include "core/portrait/reading/sparse_pose.h"
#include "core/portrait/reading/stretches.h"

namespace penpose::portrait {

/// What labelled lines say together of pose, placement and proportions. Each line's squares of doubt are those of its
/// points beside where its stretch is, less what it may slide along it. Placement and proportions cost
/// the squares of how far they are from a first guess and from the model's, over what is usual; for each pose both are
/// the best, so that what is left is a function of the controls alone (a Schur complement).
class LineSystem {
 public:
  /// `lines`: of a sheet about as large as k_face_px, about its middle. Both must outlive it.
  LineSystem(const FaceView& face, const Stretches& stretches, std::span<const Trace> lines, const Hand& hand);

  /// Lets lines slide along curves as they are in this pose and these proportions, none for those of the model, and
  /// takes what a placement does from there.
  void bend(std::span<const double> shares, std::span<const double> proportions);

  /// The first guess of the placement, in whose frame hands stray. `doubt`: of placement and proportions, of what is
  /// usual.
  void place_near(const Placement& guess, double doubt) {
    guess_ = guess;
    doubt_ = doubt;
  }
  [[nodiscard]] const Placement& guess() const { return guess_; }

  /// `weights`: of the squares of each line; empty: all 1.
  [[nodiscard]] SquaresOfDoubt squares(std::span<const Label> labels, std::span<const double> weights = {});
  /// The best placement and proportions of a pose, for the labels of the last squares().
  struct Fitted {
    Placement placement;
    std::vector<double> proportions;
    std::array<double, 4> change{};  ///< of the curves, towards the lines where the guess lays them
  };
  [[nodiscard]] Fitted fitted(std::span<const double> shares) const;
  /// The squares of doubt of each line there; 0 for those that are nothing known.
  [[nodiscard]] std::vector<double> left(std::span<const Label> labels, std::span<const double> shares,
                                         const Fitted& fitted);

 private:
  struct Block {
    bool bent = false;              ///< all but the first columns is of bent_
    std::vector<double> columns;    ///< rows of k_numbers: ways, proportions, placement
    std::vector<double> slid;       ///< one a slide: what sliding takes of each column
    std::vector<double> factor;     ///< of the slides' matrix
    std::vector<double> slides;     ///< rows of k_numbers
    std::vector<double> nuisances;  ///< rows of size_: products of proportions and placement with all columns
  };
  /// From a line, where the guess lays it, to its stretch at rest, over the width of doubt.
  [[nodiscard]] Trace off(std::size_t line, std::size_t stretch, bool reversed) const;
  /// Adds what it costs that controls move parts of the face of which nothing is drawn.
  void hold_undrawn(std::span<const Label> labels, SquaresOfDoubt& squares);
  /// The width of doubt of a point, px of the face.
  [[nodiscard]] double width() const;
  const Block& block(std::size_t stretch);
  /// The same with its nuisances.
  const Block& block_of_line(std::size_t stretch);
  /// What sliding takes of a column, one a slide.
  void slide(const Block& block, const double* column, double* out) const;
  [[nodiscard]] std::vector<double> slid_of(const Block& block, const double* column) const;

  const FaceView& face_;
  const Stretches& stretches_;
  std::span<const Trace> lines_;
  Hand hand_;
  std::size_t controls_, proportions_, size_, slides_ = 0;
  Placement guess_;
  double doubt_ = 1;
  std::vector<double> bent_;  ///< shares, then proportions
  std::deque<Block> blocks_;  ///< one a stretch
  // Of the last squares(): the factor of the nuisances' matrix, and its rows for all columns.
  std::vector<double> factor_, cross_;
};

}  // namespace penpose::portrait
