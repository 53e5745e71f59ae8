#pragma once

#include <span>

#include "core/document/model.h"
#include "core/geometry/camera.h"
#include "core/io/picture_lines/picture_lines.h"
#include "core/portrait/feature_curve.h"

namespace penpose::tracking {

/// A model as lines, as its camera sees it in its pose: its feature curves by their names, and the contours of its
/// surface, "silhouette_0" the longest. What is hidden or outside the picture is left out: of a curve that is seen in
/// several parts the longest has its name, the others NAME_2, ...; parts shorter than a hundredth of the picture's
/// longer side are none. Precondition: the curves' vertices are the model's.
[[nodiscard]] io::PictureLines line_drawing(const document::Model& model,
                                            std::span<const portrait::FeatureCurve> curves,
                                            const geometry::Camera& camera);

}  // namespace penpose::tracking
