#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/joints/body.h"
#include "core/posing/problem.h"
#include "core/rig/rig.h"

namespace penpose::intent {

/// The joints that a stroke along these points means: those with the most influence on the points, and those between
/// them in the skeleton; ascending. Empty for rigs without joints and for points that follow no joint.
/// `body`: points of a helper count for the joint that it helps, and a small overlap of the stroke with the parent of
/// its limb is ignored; null for a rig without a body.
[[nodiscard]] std::vector<std::size_t> chain_of(const rig::Rig& rig, std::span<const posing::CurvePoint> points,
                                                const joints::Body* body = nullptr);

}  // namespace penpose::intent
