#include "ui/app/view/shown_features.h"

#include <algorithm>

#include "core/curve/polyline.h"

namespace penpose::app {

using geometry::ModelPoint;
using geometry::PxPoint;
using render::CurveDrawing;

namespace {

/// Dashes of a line, so many of them.
void add_dashes(std::vector<CurveDrawing>& out, const CurveDrawing& drawing) {
  constexpr std::size_t k_points = 49, k_on = 2, k_off = 2;
  const auto even = curve::resample<ModelPoint>(drawing.points, k_points);
  if (!even) return;
  for (std::size_t i = 0; i + k_on < k_points; i += k_on + k_off) {
    CurveDrawing dash = drawing;
    dash.points.assign(even->begin() + static_cast<std::ptrdiff_t>(i),
                       even->begin() + static_cast<std::ptrdiff_t>(i + k_on + 1));
    out.push_back(std::move(dash));
  }
}

}  // namespace

std::vector<ModelPoint> feature_points(const portrait::FeatureCurve& curve, const PosedSurface& surface) {
  const auto positions = surface.positions();
  std::vector<ModelPoint> out;
  for (const posing::CurvePoint& point : curve.points) {
    ModelPoint sum(0);
    for (std::size_t k = 0; k < point.vertex.size(); ++k) {
      if (point.weight[k] != 0.0 && point.vertex[k] < positions.size())
        sum += ModelPoint(positions[point.vertex[k]]) * point.weight[k];
    }
    out.push_back(sum);
  }
  return out;
}

std::vector<PxPoint> feature_line(const portrait::FeatureCurve& curve, const PosedSurface& surface,
                                  const document::View& view) {
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  std::vector<PxPoint> out;
  for (const ModelPoint& point : feature_points(curve, surface)) {
    if (const auto px = camera ? camera->project(point) : std::nullopt) out.push_back(*px);
  }
  return out;
}

void add_features(std::vector<CurveDrawing>& out, const EditingSession& editing, const PosedSurface& surface,
                  const FeatureLook& look) {
  const document::FeatureCurves& features = editing.all_features();
  const auto add_unsure = [&](const portrait::FeatureCurve& curve) {
    CurveDrawing drawing;
    drawing.points = feature_points(curve, surface);
    drawing.color = render::from_srgb(0xd08a2a, 0.6F);
    drawing.width_px = 1.5F * look.scale;
    add_dashes(out, drawing);
  };
  const std::vector<std::string>& doubtful = features.doubtful;
  for (const portrait::FeatureCurve& curve : features.curves) {
    if (look.all && std::find(doubtful.begin(), doubtful.end(), curve.name) != doubtful.end()) {
      add_unsure(curve);
      continue;
    }
    CurveDrawing drawing;
    drawing.points = feature_points(curve, surface);
    const bool corrected = look.all && document::find_correction(*editing.document().model, curve.name) != nullptr;
    drawing.color = render::from_srgb(0x3fbf6a, corrected ? 0.9F : 0.45F);
    drawing.width_px = 1.5F * look.scale;
    out.push_back(std::move(drawing));
  }
  if (!look.all) return;
  for (const portrait::FeatureCurve& curve : features.unsure) add_unsure(curve);
}

std::optional<std::string> shown_feature_near(const EditingSession& editing, const PosedSurface& surface, PxPoint at,
                                              double within_px) {
  std::optional<std::string> found;
  double least = within_px;
  const document::FeatureCurves& features = editing.all_features();
  for (const auto* list : {&features.curves, &features.unsure}) {
    for (const portrait::FeatureCurve& curve : *list) {
      const auto seen = feature_line(curve, surface, editing.editor().view());
      const auto even = curve::resample<PxPoint>(seen, 60);
      if (!even) continue;
      for (const PxPoint& p : *even) {
        const double away = geometry::distance(p, at);
        if (away >= least) continue;
        least = away;
        found = curve.name;
      }
    }
  }
  return found;
}

}  // namespace penpose::app
