#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/judges/table/outcome.h"

namespace penpose::judges {

/// A model of the shared data with its cases; `run` reads and judges them.
struct SharedSet {
  std::string rig;
  std::vector<std::string> measures;  ///< that `run` may be asked for
  std::function<std::vector<Judged>(const std::vector<std::string>& measures)> run;
};

/// The real faces and figures, and faces of the kinds that fail, made from one of them (kinds.h). Empty where the folder
/// of shared data is not there.
[[nodiscard]] std::vector<SharedSet> shared_sets();

}  // namespace penpose::judges
