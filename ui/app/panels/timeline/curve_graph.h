#pragma once

#include <algorithm>
#include <span>

#include "core/rig/rig.h"
#include "ui/app/panels/timeline/timeline_strip.h"

// Where curves lie, and the lines and numbers around them. Private to the timeline.

namespace penpose::app {

/// The share of the height that is left above and below the ranges of controls.
inline constexpr float k_margin_share = 0.1F;

/// Where the values of controls lie on the strip: each by its own range.
struct Graph {
  Strip strip;
  std::span<const rig::Parameter> parameters;
  [[nodiscard]] float y_of(std::size_t control, double value) const {
    const rig::Parameter& range = parameters[control];
    const double span = std::max(range.maximum - range.minimum, 1e-9);
    const auto share = static_cast<float>((value - range.minimum) / span);
    return strip.to().y - (k_margin_share + share * (1 - 2 * k_margin_share)) * strip.size.y;
  }
  /// A share of the range, for the whole height that is left between the margins.
  [[nodiscard]] double share_of(float y) const {
    return static_cast<double>(((strip.to().y - y) / strip.size.y - k_margin_share) / (1 - 2 * k_margin_share));
  }
  [[nodiscard]] double value_of(std::size_t control, float y) const {
    const rig::Parameter& range = parameters[control];
    return range.minimum + share_of(y) * (range.maximum - range.minimum);
  }
};

/// Lines at frames and at values, below the curves.
void draw_grid(PanelContext& context, const TimelineOwners& with, const Graph& graph);
/// The numbers of frames at the top, those of values at the left: of the control whose key is selected, else of the
/// first one that is shown.
void draw_axis(PanelContext& context, const TimelineOwners& with, const Graph& graph);

}  // namespace penpose::app
