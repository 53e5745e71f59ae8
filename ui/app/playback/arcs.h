#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/document/commands/list/arc_commands.h"
#include "core/document/document.h"
#include "core/portrait/feature_curve.h"

namespace penpose::app {

using geometry::PxPoint;

/// The path of the middle of a curve, or of one of its ends, over time, a place a frame.
struct ShownArc {
  mesh::MeshPoint point;
  std::vector<double> moments_s;  ///< on frames
  std::vector<PxPoint> places;    ///< px of the view, one a moment
};

/// The arcs of the curves that were drawn, of their ends where those travel farther; of a document without any, of
/// those features that move farthest.
[[nodiscard]] std::vector<ShownArc> arcs_of(const document::Document& document,
                                            std::span<const portrait::FeatureCurve> features,
                                            const document::View& view, int rate);

/// What a stroke on an arc means. One that leaves the arc redraws it between where it begins and where it ends; one
/// that stays on it pulls the frame where it begins along to where it ends, and the spacing between the keys around it
/// follows. `shares`: when the pen was at each point, as a share of the stroke's time. `paced`: the redrawn part takes
/// the pen's own pace. `within_px`: how far off an arc still is on it. Nothing: it begins on none, or ends elsewhere.
[[nodiscard]] std::optional<document::RedrawArc> arc_meant(const document::Document& document,
                                                           std::span<const ShownArc> arcs, const document::View& view,
                                                           std::span<const PxPoint> line,
                                                           std::span<const double> shares, bool paced, int rate,
                                                           double within_px);

/// Arcs as of the last document and view, found anew when one of them changes.
class ArcsInSight {
 public:
  [[nodiscard]] std::span<const ShownArc> of(const document::Document& document,
                                             std::span<const portrait::FeatureCurve> features,
                                             const document::View& view, int rate);

 private:
  std::shared_ptr<const document::Timeline> timeline_;
  std::shared_ptr<const document::Model> model_;
  std::vector<std::shared_ptr<const document::PoseCurve>> curves_;
  document::View view_;
  int rate_ = 0;
  std::vector<ShownArc> arcs_;
};

}  // namespace penpose::app
