#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/portrait/assignment.h"
#include "core/portrait/placement.h"
#include "core/portrait/sparse_pose.h"

namespace penpose::portrait {

/// What labelled lines say together of pose, placement and proportions. Each line's squares of doubt are those of its
/// points beside where its stretch is, less what it may slide along it. Placement is free, proportions cost their
/// squares over their usual ones; for each pose both are the best, so that what is left is a function of the controls
/// alone (a Schur complement).
class LineSystem {
 public:
  /// `lines`: of a sheet about as large as k_face_px, about its middle. Both must outlive it. `rest`: where stretches
  /// of curves are at rest in this drawing, instead of where the model has them; empty or one a curve.
  LineSystem(const FaceView& face, std::span<const Trace> lines, double usual_proportion);

  /// Lets lines slide along curves as they are in this pose.
  void bend(std::span<const double> shares);

  [[nodiscard]] SquaresOfDoubt squares(std::span<const Label> labels);
  /// The best placement and proportions of a pose, for the labels of the last squares().
  struct Fitted {
    Placement placement;
    std::vector<double> proportions;
  };
  [[nodiscard]] Fitted fitted(std::span<const double> shares) const;
  /// Adds to what the model has at rest, px of the face: what a drawing of the face at rest showed.
  void set_rest(std::vector<std::optional<std::vector<PxPoint>>> own) { own_rest_ = std::move(own); }

 private:
  struct Block {
    std::vector<double> columns;  ///< rows of k_numbers: ways, proportions, rest
    std::vector<double> slid;     ///< rows of k_slides: what sliding takes of each column
    std::vector<double> factor;   ///< of the slides' matrix
    std::vector<double> slides;   ///< rows of k_numbers
    std::vector<double> gram;
  };
  const Block& block(std::size_t stretch);
  [[nodiscard]] std::vector<double> slid_of(const Block& block, const double* column) const;

  const FaceView& face_;
  std::span<const Trace> lines_;
  double usual_proportion_;
  std::size_t controls_, proportions_, size_;
  std::vector<double> shares_;
  std::vector<std::optional<Block>> blocks_;
  std::vector<std::optional<std::vector<PxPoint>>> own_rest_;
  // Of the last squares(): the factor of the nuisances' matrix, and its rows for all columns.
  std::vector<double> factor_, cross_;
};

}  // namespace penpose::portrait
