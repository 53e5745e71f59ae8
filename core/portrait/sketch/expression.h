#pragma once

#include <array>
#include <optional>

#include "core/portrait/sketch/measures.h"

namespace penpose::portrait {

/// The expression of a face, without its proportions. Arrays hold the left of the picture first. A part that was not
/// drawn has no value.
struct Expression {
  struct Brow {
    double raised = 0;  ///< of the distance of the eyes
    double tilted = 0;  ///< rise of the outer end over the inner one, of the brow's width
  };
  struct Mouth {
    std::array<double, 2> corners{0, 0};  ///< raised over the middle of the lips, of the width at rest
    double widened = 0;                   ///< by this share of the width at rest
    double sneered = 0;                   ///< upper lip raised, of the width at rest
    double opened = 0;                    ///< between the lips, of the width at rest
  };
  std::array<std::optional<Brow>, 2> brows;
  std::array<std::optional<double>, 2> closed;  ///< eyes: 1 is shut, below 0 wide
  std::optional<Mouth> mouth;

  [[nodiscard]] bool rests() const;
};

/// The same face at rest: another drawing by the same hand, or the model itself. `doubt` says how far a drawing strays
/// from it, as a share of how far drawings of any face stray from the usual face.
struct RestingFace {
  FaceMeasures measures;
  double doubt = 1;
};

/// Separates the expression of a drawing from the artist's style: a measure that is usual at rest is no expression.
/// `rest` is the face at rest, if it is known.
[[nodiscard]] Expression expression_of(const FaceMeasures& drawn, const std::optional<RestingFace>& rest);

}  // namespace penpose::portrait
