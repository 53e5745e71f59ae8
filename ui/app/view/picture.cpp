#include "ui/app/view/picture.h"

#include <string>

namespace penpose::app {
namespace {

bool draws_in_software(const std::string& driver) {
  return driver.find("llvmpipe") != std::string::npos || driver.find("softpipe") != std::string::npos ||
         driver.find("SWR") != std::string::npos;
}

}  // namespace

base::Result<std::unique_ptr<Picture>> Picture::make() {
  auto renderer = render::GlRenderer::make_in_current_context();
  if (!renderer) return renderer.error();
  // Darkening of creases would cost the pen its frames where there is no graphics card.
  const bool software = draws_in_software((*renderer)->driver());
  (*renderer)->set_occlusion(!software);
  // Edges averaged from four samples would take it 30 MB and half of its speed; they are smoothed when nothing moves.
  (*renderer)->set_smoothing(software);
  return std::unique_ptr<Picture>(new Picture(std::move(*renderer)));
}

base::Status Picture::draw(const DrawFrame& frame) {
  render::Scene scene;
  scene.positions = *frame.positions;
  scene.normals = *frame.normals;
  scene.triangles = frame.model->mesh->triangles();
  scene.appearance = frame.appearance.get();
  if (frame.overlay) scene.overlay = *frame.overlay;
  scene.curves = frame.curves;
  scene.wireframe = frame.wireframe;
  scene.clay = frame.clay;
  scene.background = frame.background;
  scene.shape_number = frame.shape_number;
  scene.pose_number = frame.pose_number;
  scene.overlay_number = frame.overlay_number;
  renderer_->set_behind(frame.behind);
  const auto camera = geometry::Camera::make(frame.view.camera, frame.view.viewport);
  if (!camera) return camera.error();
  return renderer_->draw(scene, *camera, 0, 0, 0);
}

}  // namespace penpose::app
