#pragma once

#include <array>
#include <optional>

#include "tests/judges/drawing/signs/expression.h"

namespace penpose::judges::drawn {

/// What of a face moves when somebody means an expression; 1: as far as people draw it. Of two: left, right.
struct Mood {
  std::array<double, 2> smile{};     ///< corners of the mouth, up; below 0 down
  double open = 0;                   ///< the mouth
  double wide = 0;                   ///< below 0: a small mouth, -1 a pucker
  std::array<double, 2> brow_in{};   ///< inner end of a brow, up
  std::array<double, 2> brow_out{};  ///< outer end
  std::array<double, 2> lid{1, 1};   ///< the eyes: 0 shut, 1 as at rest
};

/// Whether artists draw it: contempt is drawn as a smirk is, and disgust by a nose that is wrinkled, for which most
/// have no line.
[[nodiscard]] bool is_drawn(Expression expression);

/// A face at rest for what is not drawn. `strength`: 1 as people draw it.
[[nodiscard]] Mood mood_of(Expression expression, std::optional<Side> side, double strength);

}  // namespace penpose::judges::drawn
