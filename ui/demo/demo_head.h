#pragma once

#include <cstddef>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/head/head.h"

namespace penpose::demo {

/// The built-in head with the deformers that the demo's session sketches, at rest: the session is replayed up to its
/// first key pose. Errors: those of the session.
[[nodiscard]] base::Result<document::Model> make_demo_head(head::HeadEdition edition = head::HeadEdition::fourth);

/// Strokes that one deformer took: two regions, the target, and the reference where it was drawn.
[[nodiscard]] std::size_t stroke_count(const articulation::Sketch& sketch);

}  // namespace penpose::demo
