#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/geometry/bvh.h"
#include "core/geometry/camera.h"
#include "core/mesh/triangle_mesh.h"
#include "core/portrait/silhouette.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

using geometry::PxPoint;

/// So many segments of a contour have a box of their own.
inline constexpr std::size_t k_boxed = 12;
struct PxBox {
  PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
  void add(const PxPoint& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  [[nodiscard]] bool near(const PxPoint& p, double px) const {
    return p.x > low.x - px && p.x < high.x + px && p.y > low.y - px && p.y < high.y + px;
  }
};

/// A contour in the picture. The surface lies on the same side of all of them.
struct SeenContour {
  SurfaceLine points;
  std::vector<PxPoint> px;      ///< one a point
  std::vector<double> lengths;  ///< px from the first point on, one a point
  std::vector<PxBox> boxes;     ///< of each run of k_boxed segments
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
  /// The box around all of them, px.
  [[nodiscard]] PxBox box() const;
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
