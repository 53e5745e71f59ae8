#pragma once

#include <cstddef>
#include <vector>

#include "core/intent/model/control_fields.h"

namespace penpose::intent {

/// What a control is the sum of: an expression that is made of shapes, a viseme of a jaw and lips.
struct Composite {
  /// How many others, as the exponential of the entropy of their shares, so that small parts count little; 1 for a
  /// control that is no sum.
  double parts = 1;
  std::vector<std::size_t> of;  ///< the parameters, by how much of it they are; empty for a control that is no sum
};

/// One a control. A control is a sum where a few others, none of them beyond its range, do the same to the whole model
/// (greedy non-negative least squares); the clearest first, and what is a sum is no part of others. `usable`: one a
/// control, whether it may be a sum or a part.
[[nodiscard]] std::vector<Composite> composites_of(const ControlFields& fields, const std::vector<bool>& usable);

}  // namespace penpose::intent
