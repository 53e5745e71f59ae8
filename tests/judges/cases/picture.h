#pragma once

#include <span>
#include <vector>

#include "tests/judges/rigs/rig.h"

namespace penpose::judges {

using geometry::PxPoint;

/// Positions of all vertices at a pose.
[[nodiscard]] std::vector<ModelPoint> posed(const document::Model& model, const rig::Pose& pose);

/// How large a face is: the diagonal of the box of these vertices, model units.
[[nodiscard]] double size_of(std::span<const ModelPoint> places, std::span<const FaceLine> lines);

/// A face seen from afar, turned about +y, in px of which its diagonal has 800; y goes up.
class Picture {
 public:
  static constexpr double k_face_px = 800;

  /// `size`: model units.
  Picture(double yaw_degrees, double size);
  [[nodiscard]] PxPoint flat(const ModelPoint& p) const;
  [[nodiscard]] std::vector<PxPoint> flat(std::span<const ModelPoint> places,
                                          std::span<const std::uint32_t> vertices) const;
  /// The line in space, as far away in the mean as these vertices.
  [[nodiscard]] std::vector<ModelPoint> in_space(std::span<const PxPoint> line, std::span<const ModelPoint> places,
                                                 std::span<const std::uint32_t> vertices) const;

 private:
  geometry::ModelVector right_, back_;
  double px_ = 1;  ///< in a model unit
};

}  // namespace penpose::judges
