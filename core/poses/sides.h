#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "core/document/named_value.h"
#include "core/rig/rig.h"

namespace penpose::poses {

// Controls that come in two, one a side: by their names (browDown_L and browDown_R, jawLeft and jawRight).

inline constexpr std::size_t k_no_pair = static_cast<std::size_t>(-1);

/// Returns the value nearest to another one within a parameter's range.
[[nodiscard]] inline double fitted(const rig::Parameter& parameter, double value) {
  return std::clamp(value, parameter.minimum, parameter.maximum);
}

/// Returns, for each parameter, the one of the other side, or k_no_pair.
[[nodiscard]] std::vector<std::size_t> side_pairs(std::span<const rig::Parameter> parameters);

/// Returns the pose with both sides exchanged. What the other side cannot do is as much as it can. `count`: parameters
/// from there on are joints', whose sides turn in ways of their own, and stay.
[[nodiscard]] rig::Pose flipped(std::span<const rig::Parameter> parameters, std::span<const std::size_t> pairs,
                                const rig::Pose& pose, std::size_t count);

/// How much of a pose is taken, and on which side.
struct PoseShare {
  bool mirrored = false;  ///< left and right exchanged
  double amount = 1;      ///< 0..1 of the way
};

/// Returns values that take a share of what `values` do to the pose `from`. Mirrored, what is named goes to the other
/// side, and what the other side had there comes to this one; what has no other side stays. Values are within their
/// ranges. Names that the model does not have are left out.
[[nodiscard]] std::vector<document::NamedValue> shared_values(const document::Model& model, const rig::Pose& from,
                                                              const std::vector<document::NamedValue>& values,
                                                              const PoseShare& share);

}  // namespace penpose::poses
