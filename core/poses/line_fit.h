#pragma once

#include <optional>

#include "core/poses/face_measure.h"

namespace penpose::poses {

/// The values of a rig's own controls, from rest, that the lines of a pose mean (intent::solve): each is laid over the
/// feature of its name, seen from where it was drawn. Errors: no line is of a feature that the face has, and those of
/// the solver.
[[nodiscard]] base::Result<rig::Pose> fit_lines(const FaceMeasure& face, const rig::Rig& rig,
                                                const std::vector<KeptLine>& lines, FacePart part);

}  // namespace penpose::poses
