#include <vector>

#include "tests/judges/drawing/drawing_measures.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

std::span<const Measure> all_measures() {
  const auto drawings = known_drawing_measures();
  static const std::vector<Measure> all{intent_measure(), gesture_measure(), body_measure(),       exact_measure(),
                                        meant_measure(),  drawings[0],       drawings[1],          drawings[2],
                                        drawn_face_measure(), no_face_measure(), shared_drawing_measure()};
  return all;
}

}  // namespace penpose::judges
