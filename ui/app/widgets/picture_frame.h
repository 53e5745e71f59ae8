#pragma once

#include <array>

#include "core/document/model.h"
#include "core/geometry/space.h"
#include "ui/app/session/pose_library.h"

namespace penpose::app {

/// What a small square picture from the front shows, model units.
struct PictureFrame {
  geometry::ModelPoint middle{0};
  double side = 1;
};

/// What pictures of a model's poses show, by FacePart: of a part what its controls move, found as `part_of` does (of
/// the mouth nearer, what those of the lips do); of all the whole face. Where names say nothing it is what most shapes
/// move (render::face_vertices), else the model.
using PictureFrames = std::array<PictureFrame, 4>;
[[nodiscard]] PictureFrames picture_frames(const document::Model& model);

}  // namespace penpose::app
