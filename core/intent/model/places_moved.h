#pragma once

#include <vector>

#include "core/intent/model/whole_model.h"

namespace penpose::intent {

/// Finds the separate places that each shape moves (WholeModel::places). `shapes` says for each control whether it is
/// one.
[[nodiscard]] std::vector<std::vector<WholeModel::PlaceMoved>> places_moved(const ControlFields& fields,
                                                                            const std::vector<bool>& shapes);

}  // namespace penpose::intent
