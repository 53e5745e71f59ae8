#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/document/document.h"
#include "core/intent/model/whole_model.h"
#include "core/portrait/feature_curve.h"

namespace penpose::document {

/// What a drawing of a face is read from (portrait::pose_from_drawing).
struct DrawingStart {
  rig::Pose pose;                 ///< where nothing has moved
  std::vector<std::size_t> free;  ///< parameters that may move, ascending
};

/// A drawing shows the face from rest, whatever pose the document is in: controls start there, joints where they are.
/// What is locked stays as it is. Joints stay where anything else moves the curves.
[[nodiscard]] DrawingStart drawing_start(const Document& document, const intent::WholeModel& whole,
                                         std::span<const portrait::FeatureCurve> curves);

}  // namespace penpose::document
