#include "core/document/features/drawing_start.h"

#include <algorithm>

namespace penpose::document {

namespace {

/// Whether anything but joints moves these curves.
bool moved_by_shapes(const Model& model, const intent::WholeModel& whole,
                     std::span<const portrait::FeatureCurve> curves) {
  std::vector<std::uint32_t> vertices;
  for (const portrait::FeatureCurve& curve : curves) {
    for (const posing::CurvePoint& point : curve.points)
      vertices.insert(vertices.end(), point.vertex.begin(), point.vertex.end());
  }
  const auto bound = model.rig->bind(vertices);
  for (std::size_t p = 0; p < model.rig->parameters().size(); ++p) {
    if (whole.joint[p] == intent::k_no_partner && bound->moves(p)) return true;
  }
  return false;
}

}  // namespace

DrawingStart drawing_start(const Document& document, const intent::WholeModel& whole,
                           std::span<const portrait::FeatureCurve> curves) {
  const auto parameters = document.model->rig->parameters();
  const bool shapes = moved_by_shapes(*document.model, whole, curves);
  DrawingStart out{document.pose, {}};
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    if (std::binary_search(document.locked.begin(), document.locked.end(), parameters[p].name)) continue;
    const bool turns = whole.joint[p] != intent::k_no_partner;
    if (!turns) out.pose[p] = parameters[p].rest;
    if (!turns || !shapes) out.free.push_back(p);
  }
  return out;
}

}  // namespace penpose::document
