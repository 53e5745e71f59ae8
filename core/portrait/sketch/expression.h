#pragma once

#include <array>
#include <optional>

#include "core/portrait/sketch/measures.h"

namespace penpose::portrait {

/// What a face shows beyond its proportions. Sides as in FaceMeasures. What is not drawn has no value.
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

/// What the same face is like at rest: another drawing by the same hand, or the model itself. `doubt`: how far what is
/// drawn strays from it, of what drawings of any face stray from the usual face.
struct RestingFace {
  FaceMeasures measures;
  double doubt = 1;
};

/// Says what of a drawing is expression and what is the way this person draws: what is usual at rest is no expression.
/// `rest`: where it is known.
[[nodiscard]] Expression expression_of(const FaceMeasures& drawn, const std::optional<RestingFace>& rest);

}  // namespace penpose::portrait
