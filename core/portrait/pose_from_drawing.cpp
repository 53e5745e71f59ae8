#include "core/portrait/pose_from_drawing.h"

#include <algorithm>

namespace penpose::portrait {

base::Result<DrawnPose> pose_from_drawing(const rig::Rig& rig, const intent::WholeModel& whole,
                                          std::span<const FeatureCurve> curves, const Drawing& drawing,
                                          const geometry::Camera& camera, const rig::Pose& start,
                                          std::span<const std::size_t> free) {
  const auto face = FaceView::make(rig, whole, curves, start, free, camera);
  if (!face) return face.error();
  auto read = read_drawing(*face, drawing);
  if (!read) return read.error();
  DrawnPose out{start, std::move(*read)};
  for (std::size_t j = 0; j < out.read.shares.size(); ++j) {
    const std::size_t p = face->controls()[j].parameter;
    const rig::Parameter& parameter = rig.parameters()[p];
    const double value = start[p] + out.read.shares[j] * (parameter.maximum - parameter.minimum);
    out.pose[p] = std::clamp(value, parameter.minimum, parameter.maximum);
  }
  return out;
}

geometry::Camera camera_of_drawing(const rig::Rig& rig, std::span<const FeatureCurve> curves, const rig::Pose& start,
                                   double yaw_degrees) {
  constexpr double k_far = 1.0;  // degrees of view: nothing is nearer than the rest
  std::vector<geometry::ModelPoint> places(rig.vertex_count());
  rig.evaluate(start, places);
  geometry::Box box;
  for (const FeatureCurve& curve : curves) {
    for (const posing::CurvePoint& point : curve.points) {
      for (std::size_t k = 0; k < point.vertex.size(); ++k) {
        if (point.weight[k] != 0.0 && point.vertex[k] < places.size()) box.add(places[point.vertex[k]]);
      }
    }
  }
  return geometry::frame_box(box, {1000, 1000}, yaw_degrees, 0, k_far);
}

}  // namespace penpose::portrait
