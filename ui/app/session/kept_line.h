#pragma once

#include <span>

#include "core/curve/stroke.h"
#include "core/document/document.h"

namespace penpose::app {

/// How much of a drawn line became a curve, 0..1: where a line leaves the part of the surface that most of it is on,
/// only its longest piece is kept. By the boxes of both in the picture, so that an unsteady hand makes no difference. 1
/// where that is not known.
[[nodiscard]] double kept_share(const document::Document& document, const document::PoseCurve& curve,
                                const document::View& view, std::span<const curve::StrokeSample> drawn);

}  // namespace penpose::app
