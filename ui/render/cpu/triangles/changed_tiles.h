#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ui/render/cpu/triangles/screen_vertices.h"
#include "ui/render/draw_list.h"

namespace penpose::render {

/// The tiles of DrawItems in which triangles are, or were, that a vertex has moved of. Nothing: all may look different,
/// because something is or was clipped.
[[nodiscard]] std::optional<std::vector<bool>> changed_tiles(const DrawList& list, geometry::Viewport size,
                                                             std::span<const ScreenVertex> before,
                                                             std::span<const ScreenVertex> now);

}  // namespace penpose::render
