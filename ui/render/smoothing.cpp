#include "ui/render/smoothing.h"

#include <utility>

namespace penpose::render {
PictureSource::PictureSource(const Scene& scene, const geometry::Camera& camera, Behind behind)
    : shape_(scene.shape_number),
      pose_(scene.pose_number),
      overlay_(scene.overlay_number),
      has_overlay_(!scene.overlay.empty()),
      wireframe_(scene.wireframe),
      clay_(scene.clay),
      matcap_(scene.matcap),
      background_(scene.background),
      camera_(camera.pose()),
      viewport_(camera.viewport()),
      behind_(std::move(behind)) {}

bool PictureSource::same_but_pose(const PictureSource& other) const {
  return numbered() && shape_ == other.shape_ && overlay_ == other.overlay_ && has_overlay_ == other.has_overlay_ &&
         (overlay_ != 0 || !has_overlay_) && wireframe_ == other.wireframe_ && clay_ == other.clay_ &&
         matcap_ == other.matcap_ && camera_ == other.camera_ && viewport_ == other.viewport_ &&
         behind_ == other.behind_ && same_background(background_, other.background_);
}

}  // namespace penpose::render
