#pragma once

#include "tests/judges/rigs/parts.h"

namespace penpose::judges {

/// Places of a face that its lines tell. Index 0 is _L (+x), 1 is _R.
struct Landmarks {
  ModelPoint mouth{0}, chin{0}, nose{0};
  ModelPoint eyes[2], corners[2], brows[2];
  double eye = 0;      ///< half the width of an eye
  double mouth_w = 0;  ///< half the width of the mouth
  double low = 0, high = 0;
};

[[nodiscard]] Landmarks landmarks_of(const Parts& parts);

}  // namespace penpose::judges
