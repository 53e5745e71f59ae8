#pragma once

#include <vector>

#include "core/document/model.h"
#include "core/model_io/landmark_file.h"

namespace penpose::model_io {

/// Curves of brows, lids and lips, by the names that the bundled maps use, of heads whose vertices are numbered in a
/// known way. Known: ICT FaceKit (Li et al. 2020), whole or the face alone, by the 68 landmark vertices that its
/// documentation lists. Empty for every other model; a model is known by its vertex count, its controls and by the
/// landmarks lying where a face has them.
[[nodiscard]] std::vector<VertexCurve> known_head_curves(const document::Model& model);

}  // namespace penpose::model_io
