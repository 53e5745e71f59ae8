#pragma once

#include <vector>

#include "core/document/features/vertex_curve.h"
#include "core/document/model.h"

namespace penpose::document {

/// Curves of brows, lids and lips, by the names that the bundled maps use, of heads whose vertices are numbered in a
/// known way. Known: ICT FaceKit (Li et al. 2020), whole or the face alone, by the 68 landmark vertices that its
/// documentation lists. A model is known by its topology, that is by edges that all its triangulations have, or by most
/// of them and the names of its controls, and by the order of the curves down the face; never by its form, so that
/// every identity of the kit is known. Empty for every other model.
[[nodiscard]] std::vector<VertexCurve> known_head_curves(const Model& model);

}  // namespace penpose::document
