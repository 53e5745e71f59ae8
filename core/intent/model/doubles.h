#pragma once

#include <cstddef>
#include <vector>

#include "core/intent/model/whole_model.h"

namespace penpose::intent {

/// A control for whose effect there are others, too: it is their sum, or one of them does the same.
struct DoubleControl {
  std::size_t parameter = 0;
  std::vector<std::size_t> of;  ///< parameters; one: it does the same, apart from how far
};

/// The doubles of a rig, in its order. Of controls that do the same, each but the first is the double of the first.
/// Joints are none. `whole` is that of a rig.
[[nodiscard]] std::vector<DoubleControl> doubles_of(const WholeModel& whole);

}  // namespace penpose::intent
