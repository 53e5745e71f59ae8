#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/document/drawing/pose_curve.h"
#include "ui/app/view/area.h"
#include "ui/render/scene.h"

namespace penpose::app {

/// Over so many seconds what was said fades before it goes.
inline constexpr double k_fade_s = 0.5;

/// Holds the area of the notices in the last frame; nothing if there were none.
struct ToastPlace {
  std::optional<Area> area;
};

/// A place for something of some size in an area, in the corner of it that covers none of the points; where each covers
/// some, the one that covers the fewest. The lower left is taken first, then the lower right, the upper ones.
[[nodiscard]] Area toast_place(const Area& inside, double width, double height, std::span<const PxPoint> points);

/// Everything drawn that the canvas shows, as points close to each other: lines, targets and the stroke under the pen.
[[nodiscard]] std::vector<PxPoint> drawn_px(const document::View& view, std::span<const render::CurveDrawing> curves);

}  // namespace penpose::app
