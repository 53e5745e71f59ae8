#pragma once

#include <algorithm>

#include "ui/render/scene.h"
#include "ui/render/view.h"

namespace penpose::render {

/// How far darkening of creases looks in a view's units: of a face that is looked at closely no farther than on a bust,
/// however large the figure is that it belongs to.
[[nodiscard]] inline float crease_radius(const View& view) {
  const float half_height = view.image_plane.y * std::max(-view.to_view[3].z, 0.0F);
  return std::min(k_occlusion_radius, std::max(0.22F * half_height, 0.005F));
}

}  // namespace penpose::render
