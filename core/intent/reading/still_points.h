#pragma once

#include <optional>

#include "core/intent/problem.h"

namespace penpose::intent {

/// The part of a corrected curve that holds still: where the points that the line does not touch (DrawnCurve::stays)
/// are at a pose. Those next to what it touches give way. Nothing where none are left. Precondition: check_problem
/// passed.
[[nodiscard]] std::optional<KnownCurve> still_points(const rig::Rig& rig, const rig::Pose& pose,
                                                     const DrawnCurve& curve);

}  // namespace penpose::intent
