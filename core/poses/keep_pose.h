#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/poses/face_measure.h"

namespace penpose::poses {

/// A pose of a document, for a file of its own. `face`: of its model, null where it has no features; `lines`: those
/// that the pose was drawn with. Pictures stay empty.
[[nodiscard]] KeptPose keep_pose(const document::Document& document, const rig::Pose& pose, const std::string& name,
                                 const std::string& model, const FaceMeasure* face, std::vector<KeptLine> lines);

/// The lines of a document that lie along features of the face: drawn faces, and targets whose reference lies on one.
/// `shown`: whether a curve is of the pose that is kept.
[[nodiscard]] std::vector<KeptLine> lines_of(const document::Document& document, const FaceMeasure& face,
                                             const std::function<bool(document::CurveId)>& shown);

}  // namespace penpose::poses
