#pragma once

#include <span>
#include <vector>

#include "core/geometry/bvh.h"
#include "core/geometry/camera.h"
#include "core/mesh/triangle_mesh.h"
#include "core/portrait/silhouette.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

using geometry::PxPoint;

/// A contour in the picture. The surface lies on the same side of all of them.
struct SeenContour {
  SurfaceLine points;
  std::vector<PxPoint> px;      ///< one a point
  std::vector<double> lengths;  ///< px from the first point on, one a point
  bool closed = false;
};

/// The contours of a rig that one camera sees, found anew for each pose.
class SeenContours {
 public:
  /// Precondition: the mesh is the rig's, and all outlive this.
  SeenContours(const rig::Rig& rig, const mesh::TriangleMesh& mesh, const geometry::Camera& camera);

  /// Those of a pose, the longest first; what is shorter than a hundredth of the picture's height is left out.
  void look(const rig::Pose& pose);
  [[nodiscard]] std::span<const SeenContour> lines() const { return lines_; }
  /// The corners of the box around all of them, px; the first one above the second where there are none.
  [[nodiscard]] std::pair<PxPoint, PxPoint> box() const;
  [[nodiscard]] const geometry::Camera& camera() const { return camera_; }
  /// Of all vertices, in the pose that was looked at last.
  [[nodiscard]] std::span<const geometry::ModelPoint> positions() const { return positions_; }

 private:
  const rig::Rig& rig_;
  const mesh::TriangleMesh& mesh_;
  geometry::Camera camera_;
  std::vector<geometry::ModelPoint> positions_;
  std::vector<glm::vec3> floats_;
  geometry::TriangleBvh tree_;
  std::vector<SeenContour> lines_;
};

}  // namespace penpose::portrait
