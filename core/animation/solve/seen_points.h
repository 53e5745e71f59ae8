#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/geometry/camera.h"
#include "core/posing/problem.h"
#include "core/rig/rig.h"

namespace penpose::animation {

/// Projects points of a rig in any pose. Rig and camera must outlive it.
class SeenPoints {
 public:
  SeenPoints(const rig::Rig& rig, std::vector<posing::CurvePoint> points, const geometry::Camera& camera);

  /// One place a point, px of the camera; (0, 0) behind it. Precondition: one value of `pose` a parameter.
  [[nodiscard]] std::vector<geometry::PxPoint> at(std::span<const double> pose);

 private:
  const geometry::Camera& camera_;
  std::vector<posing::CurvePoint> points_;
  std::unique_ptr<rig::BoundVertices> bound_;
  std::vector<geometry::ModelPoint> positions_;
};

}  // namespace penpose::animation
