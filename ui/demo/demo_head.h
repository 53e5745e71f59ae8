#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "ui/demo/expression_file.h"

namespace penpose::demo {

/// The built-in head with the deformers of the bundled sketch, built as `penpose articulate` builds them. Errors: those
/// of the sketch.
[[nodiscard]] base::Result<document::Model> make_demo_head();
/// The same, from a head and any sketch file.
[[nodiscard]] base::Result<document::Model> articulate(document::Model model, std::string_view sketch_file);

/// The bundled expressions.
[[nodiscard]] base::Result<ExpressionFile> demo_expressions();

/// Strokes that one deformer took: two regions, the target, and the reference where it was drawn.
[[nodiscard]] std::size_t stroke_count(const articulation::Sketch& sketch);

}  // namespace penpose::demo
