#pragma once

#include "core/geometry/camera.h"
#include "ui/render/behind.h"
#include "ui/render/scene.h"

// A still picture gets smoother by being drawn again and again, each time moved by a part of a px.
namespace penpose::render {

/// Pictures that are averaged, and where each samples its px: a Halton sequence of bases 2 and 3 around the middle.
inline constexpr int k_smoothing_passes = 8;
inline constexpr float k_smoothing_places[k_smoothing_passes][2] = {
    {0, 0},           {-0.25F, 0.167F},   {0.25F, -0.389F}, {-0.375F, -0.056F},
    {0.125F, 0.278F}, {-0.125F, -0.278F}, {0.375F, 0.056F}, {-0.438F, 0.389F}};

/// What the surfaces of a picture were drawn from.
class PictureSource {
 public:
  PictureSource() = default;
  PictureSource(const Scene& scene, const geometry::Camera& camera, Behind behind);

  /// Whether they would look the same. Of a scene without numbers nobody knows.
  [[nodiscard]] bool same_as(const PictureSource& other) const { return pose_ == other.pose_ && same_but_pose(other); }
  /// Whether they would, if the pose were the same.
  [[nodiscard]] bool same_but_pose(const PictureSource& other) const;
  /// Whether the scene has the numbers by which another picture can be known to be the same.
  [[nodiscard]] bool numbered() const { return shape_ != 0 && pose_ != 0; }

 private:
  std::uint64_t shape_ = 0, pose_ = 0, overlay_ = 0;
  bool has_overlay_ = false;
  bool wireframe_ = false;
  bool clay_ = false;
  bool matcap_ = false;
  Background background_;
  geometry::CameraPose camera_;
  geometry::Viewport viewport_;
  Behind behind_;
};

}  // namespace penpose::render
