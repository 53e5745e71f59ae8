#pragma once

#include <optional>

#include "core/geometry/camera.h"
#include "ui/render/scene.h"
#include "ui/render/view.h"

namespace penpose::render {

/// The ground's square (BakedLight) as a view has it.
struct GroundView {
  glm::vec3 eye{0};  ///< from the middle of the square, in its half sides
  /// Where it is seen, px from the upper left.
  int left = 0, top = 0, right = 0, bottom = 0;
};
/// Nothing: there is no ground, the eye is below it, or the picture does not show it.
[[nodiscard]] std::optional<GroundView> view_of_ground(const BakedLight& light, const View& view,
                                                       geometry::Viewport size);

}  // namespace penpose::render
