#include "ui/film/film_ghosts.h"

#include <algorithm>

namespace penpose::film {
namespace {

/// Lines of a picture this high are as broad as on an ordinary display.
constexpr double k_usual_height = 900, k_least_scale = 0.6;

}  // namespace

void FilmGhosts::add(const document::Document& document, double time_s, double rate, const geometry::Camera& camera,
                     render::Scene& scene, render::Renderer& renderer) {
  faces_.look_at({document, document::features_of(document, work_), {camera.pose(), camera.viewport()}, time_s, rate},
                 look_);
  render::GhostInk ink;
  ink.scale = static_cast<float>(std::max(k_least_scale, camera.viewport().height / k_usual_height));
  curves_ = render::ghost_drawings(faces_.ghosts(), scene.positions, camera, ink);
  scene.curves = curves_;
  if (look_.style != render::GhostStyle::faces || scene.appearance == nullptr) return;
  // The numbers of one film: its model stays.
  renderer.set_veil(
      veil_.draw(faces_.ghosts(), {*document.model->mesh, *scene.appearance, 1, scene.positions}, camera, ink));
}

}  // namespace penpose::film
