#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/joints/body.h"
#include "core/posing/problem.h"
#include "core/rig/rig.h"

namespace penpose::intent {

/// The joints that a stroke along these points means: those that carry the points most, and those between them in the
/// skeleton; ascending. Empty for rigs without joints and points that no joint carries.
/// `body`: what a helper carries belongs to the joint that it helps, and where a stroke overlaps a little what its limb
/// hangs on, that is not meant; null for a rig without a body.
[[nodiscard]] std::vector<std::size_t> chain_of(const rig::Rig& rig, std::span<const posing::CurvePoint> points,
                                                const joints::Body* body = nullptr);

}  // namespace penpose::intent
