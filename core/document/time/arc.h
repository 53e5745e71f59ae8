#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/geometry/camera.h"
#include "core/posing/problem.h"

namespace penpose::document {

using geometry::PxPoint;

/// Where a point of the model is in a picture while time runs.
class ArcView {
 public:
  /// Preconditions: the vertices of the point exist, and the document stays.
  ArcView(const Document& document, const posing::CurvePoint& point, const geometry::Camera& camera);

  /// Nothing: it is behind the eye.
  [[nodiscard]] std::optional<PxPoint> at(std::span<const double> pose) const;
  [[nodiscard]] bool moves(std::size_t parameter) const { return bound_->moves(parameter); }

 private:
  posing::CurvePoint point_;
  geometry::Camera camera_;
  std::unique_ptr<rig::BoundVertices> bound_;
};

/// The poses of the timeline at moments (pose_at).
[[nodiscard]] std::vector<rig::Pose> poses_of_timeline(const Document& document, std::span<const double> moments_s);
/// A point of the model in poses, px.
[[nodiscard]] std::vector<PxPoint> arc_of(const Document& document, const posing::CurvePoint& point,
                                          const geometry::Camera& camera, std::span<const rig::Pose> poses);

/// Where the point should be, one place a frame.
struct ArcTarget {
  std::vector<double> moments_s;  ///< ascending, at least two
  std::vector<PxPoint> points;    ///< one a moment
};
/// The target along a drawn line. `line`: px, at least two points. `shares`: when the line is at each of its points, as
/// a share of the time, ascending; empty: the spacing is that of `now`, by length along it.
[[nodiscard]] ArcTarget target_along(std::span<const PxPoint> line, std::span<const double> shares,
                                     std::span<const double> moments_s, std::span<const PxPoint> now);

/// The timeline with an arc as it should be: at each moment the controls that move the point change as little as they
/// can, within their ranges. Those that move in these moments anyway do it alone where that is enough; else shapes and
/// sketched controls help, as few as are enough, and joints only where all of these are not. What comes of it is fitted
/// by as few keys as keep it within 0.7 px. Outside of the moments nothing changes. Controls that are locked stay.
/// Errors: the point is behind the eye, or nothing that is free moves it.
[[nodiscard]] base::Result<Timeline> with_arc(const Document& document, const posing::CurvePoint& point,
                                              const geometry::Camera& camera, const ArcTarget& target);

}  // namespace penpose::document
