#pragma once

#include "tests/judges/rigs/builder.h"
#include "tests/judges/rigs/random/dice.h"

namespace penpose::judges {

/// How strong a maker makes a shape, and what else it moves beside what it is for. Both sides of a shape are alike.
class Taste {
 public:
  /// `parts` must outlive it: what a face does not have is left out.
  Taste(const Parts& parts, const Dice& dice);
  /// False: the face has no such muscle, or the maker leaves out the shape.
  [[nodiscard]] bool make(Recipe& recipe) const;

 private:
  const Parts& parts_;
  Dice dice_;
  double spill_ = 0;          ///< 0..1
  double strength_ = 0;       ///< the share of shapes that are weak or strong
  double lacks_ = 0;          ///< the share of shapes that are left out
  bool weak_smiles_ = false;  ///< beside strong ways to narrow the mouth
};

}  // namespace penpose::judges
