#pragma once

#include <vector>

#include "core/intent/model/whole_model.h"
#include "core/mesh/triangle_mesh.h"
#include "core/portrait/feature_curve.h"
#include "core/portrait/surface/surface_paint.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

/// A feature curve and how sure it is one: 0..1.
struct FoundCurve {
  FeatureCurve curve;
  double sureness = 0;
};

/// Curves that are less sure than this should be drawn by hand.
inline constexpr double k_sure = 0.45;

/// Finds the feature curves of a face from its shape, from what its controls move and from its paint, never from names.
/// What is not found is left out.
[[nodiscard]] std::vector<FoundCurve> find_features(const rig::Rig& rig, const mesh::TriangleMesh& mesh,
                                                    const intent::WholeModel& whole, double front_yaw_degrees,
                                                    const SurfacePaint& paint = {});

}  // namespace penpose::portrait
