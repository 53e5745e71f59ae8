#include <vector>

#include "tests/judges/drawing/drawing_measures.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

std::span<const Measure> all_measures() {
  static const std::vector<Measure> all = [] {
    std::vector<Measure> some{intent_measure(), gesture_measure(), body_measure(), exact_measure(), meant_measure()};
    for (const Measure& one : drawing_measures()) some.push_back(one);
    return some;
  }();
  return all;
}

}  // namespace penpose::judges
