#pragma once

#include <vector>

#include "core/document/document.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// The curves of a document's posing tool as they lie now: references green, their targets and lines of a face blue,
/// constraints red, pins as dots.
[[nodiscard]] std::vector<CurveDrawing> document_curves(const document::Document& document);

}  // namespace penpose::render
