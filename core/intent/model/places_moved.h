#pragma once

#include <vector>

#include "core/intent/model/whole_model.h"

namespace penpose::intent {

/// See WholeModel::places. `shapes`: one a control.
[[nodiscard]] std::vector<std::vector<WholeModel::PlaceMoved>> places_moved(const ControlFields& fields,
                                                                            const std::vector<bool>& shapes);

}  // namespace penpose::intent
