#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/judges/rigs/rig.h"
#include "tests/judges/table/outcome.h"

namespace penpose::judges {

/// A model of the shared data with its cases; `run` reads and judges them.
struct SharedSet {
  std::string rig;
  std::vector<std::string> measures;  ///< that `run` may be asked for
  std::function<std::vector<Judged>(const std::vector<std::string>& measures)> run;
  std::function<Rig()> rig_of;  ///< for measures that make their own cases (needs_cases); empty: none
};

/// Whether a measure of a shared model takes its cases from files alone.
[[nodiscard]] bool needs_cases(const std::string& measure);

/// The real faces and figures, and faces of the kinds that fail, made from one of them (kinds.h). Empty where the
/// folder of shared data is not there.
[[nodiscard]] std::vector<SharedSet> shared_sets();

}  // namespace penpose::judges
