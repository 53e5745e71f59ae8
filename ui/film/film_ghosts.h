#pragma once

#include <vector>

#include "core/document/commands/apply.h"
#include "core/document/document.h"
#include "ui/render/appearance.h"
#include "ui/render/cpu/ghost_veil.h"
#include "ui/render/ghosts/ghost_drawings.h"
#include "ui/render/renderer.h"

namespace penpose::film {

/// The face before and after in the frames of a film, as the window shows it on its canvas. Keeps what goes on from
/// frame to frame.
class FilmGhosts {
 public:
  explicit FilmGhosts(const render::GhostLook& look) : look_(look) {}

  /// Adds them to what a frame shows. Precondition: the scene is of the document's model. Its curves are valid until
  /// the next call.
  void add(const document::Document& document, double time_s, double rate, const geometry::Camera& camera,
           render::Scene& scene, render::Renderer& renderer);
  /// Faces that were posed since the beginning.
  [[nodiscard]] std::uint64_t posed() const { return faces_.posed(); }

 private:
  render::GhostLook look_;
  document::ApplyWorkspace work_;
  render::GhostFaces faces_;
  render::GhostVeil veil_;
  std::vector<render::CurveDrawing> curves_;
};

}  // namespace penpose::film
