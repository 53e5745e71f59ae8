#pragma once

#include "core/base/result.h"
#include "core/document/commands/command.h"
#include "core/document/drawing/pose_curve.h"

namespace penpose::document {

/// A target pulled at a place of a view (curve/bend.h). Its points move parallel to the picture; those that do not
/// follow keep their exact positions. Errors: an invalid camera, a target behind it or of no length in it, an invalid
/// pull or reach.
[[nodiscard]] base::Result<DrawnTarget> pulled_target(const DrawnTarget& before, const PullTarget& pull);

}  // namespace penpose::document
