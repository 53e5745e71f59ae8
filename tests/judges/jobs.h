#pragma once

#include <string>
#include <vector>

#include "tests/judges/measures/measure.h"

namespace penpose::judges {

/// Selects measures and rigs.
struct Wanted {
  Extent extent = Extent::whole;
  std::vector<std::string> measures, rigs;  ///< empty: all
  bool shared = true;                       ///< the shared models, too, where they are
};

/// What measures say of rigs, in the order of measures and then of rigs. Rigs are judged at the same time on all
/// processors; the result is the same for any number of them.
[[nodiscard]] std::vector<Judged> judge_all(const Wanted& wanted);

}  // namespace penpose::judges
