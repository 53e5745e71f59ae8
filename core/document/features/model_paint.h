#pragma once

#include "core/document/model.h"
#include "core/portrait/surface/surface_paint.h"

namespace penpose::document {

/// Returns the paint of a model from its textures and the colours of its vertices; empty if it has neither. A texture
/// is unpacked when the first place on it is asked for, and counts as white if it cannot be. The result keeps what it
/// needs of the model and is not for several threads at a time.
[[nodiscard]] portrait::SurfacePaint paint_of(const Model& model);

}  // namespace penpose::document
