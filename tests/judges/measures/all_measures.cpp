#include <vector>

#include "tests/judges/measures/measure.h"

namespace penpose::judges {

std::span<const Measure> all_measures() {
  static const std::vector<Measure> all{intent_measure(), gesture_measure(), body_measure(), exact_measure(),
                                        meant_measure()};
  return all;
}

}  // namespace penpose::judges
