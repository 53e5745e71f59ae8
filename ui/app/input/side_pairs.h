#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/commands/command.h"
#include "core/poses/sides.h"
#include "core/rig/rig.h"

namespace penpose::app {

// Controls that come in two, one a side: by their names (browDown_L and browDown_R, jawLeft and jawRight).

using poses::flipped;
using poses::k_no_pair;
using poses::side_pairs;

/// Those of the pairs that do the same on two sides, as a measured model says (intent::WholeModel::partner); jawLeft
/// and jawRight do not.
[[nodiscard]] std::vector<std::size_t> two_sided(std::vector<std::size_t> pairs, std::span<const std::size_t> partner);
/// What both names of a pair have in common: "browDown", "jaw"; the first name where that is nothing.
[[nodiscard]] std::string common_name(const std::string& first, const std::string& second);
/// Whether a name is that of the left side. Precondition: it has a side.
[[nodiscard]] bool is_left(const std::string& name, const std::string& other);

/// One side's values on both.
[[nodiscard]] rig::Pose copied_over(std::span<const rig::Parameter> parameters, std::span<const std::size_t> pairs,
                                    const rig::Pose& pose, std::size_t count, bool from_left);
/// What was done on one side, done on both: where the change from `before` is mostly one side's, the pose with that
/// side's values on the other too. Nothing: both sides moved, or none, or the other side stands there already.
[[nodiscard]] std::optional<rig::Pose> on_both_sides(std::span<const rig::Parameter> parameters,
                                                     std::span<const std::size_t> pairs, const rig::Pose& before,
                                                     const rig::Pose& now, std::size_t count);

/// The command that takes one pose to another; empty: they are the same.
[[nodiscard]] document::SetParameters values_between(std::span<const rig::Parameter> parameters, const rig::Pose& from,
                                                     const rig::Pose& to);

}  // namespace penpose::app
