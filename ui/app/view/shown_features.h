#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/app/session/editing_session.h"
#include "ui/app/view/posed_surface.h"
#include "ui/render/scene.h"

namespace penpose::app {

struct FeatureLook {
  float scale = 1;   ///< px of the display for each px of an ordinary one
  bool all = false;  ///< also those that are not sure, dashed; what was corrected is brighter
};

/// Where a feature of the face lies now.
[[nodiscard]] std::vector<geometry::ModelPoint> feature_points(const portrait::FeatureCurve& curve,
                                                               const PosedSurface& surface);
/// The same in px of the view; what is behind the camera is left out.
[[nodiscard]] std::vector<geometry::PxPoint> feature_line(const portrait::FeatureCurve& curve,
                                                          const PosedSurface& surface, const document::View& view);

/// Adds the features of the face as thin lines.
void add_features(std::vector<render::CurveDrawing>& out, const EditingSession& editing, const PosedSurface& surface,
                  const FeatureLook& look);

/// The feature whose line is nearest to a place, sure or not; nothing: none is within that distance.
[[nodiscard]] std::optional<std::string> shown_feature_near(const EditingSession& editing, const PosedSurface& surface,
                                                            geometry::PxPoint at, double within_px);

}  // namespace penpose::app
