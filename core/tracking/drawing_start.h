#pragma once

#include <cstddef>
#include <vector>

#include "core/document/document.h"
#include "core/intent/model/whole_model.h"

namespace penpose::tracking {

/// What a drawing of a face is read from (portrait::pose_from_drawing).
struct DrawingStart {
  rig::Pose pose;                 ///< where nothing has moved
  std::vector<std::size_t> free;  ///< parameters that may move, ascending
};

/// A drawing shows the face from rest, whatever pose the document is in: controls start there, joints where they are.
/// What is locked stays as it is.
[[nodiscard]] DrawingStart drawing_start(const document::Document& document, const intent::WholeModel& whole);

}  // namespace penpose::tracking
