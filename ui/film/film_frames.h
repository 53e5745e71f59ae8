#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/geometry/camera.h"
#include "core/geometry/placement.h"
#include "ui/film/film_ghosts.h"
#include "ui/render/appearance.h"
#include "ui/render/renderer.h"

namespace penpose::film {

/// A part of a picture, px.
struct PxPart {
  int left = 0;
  int top = 0;
  geometry::Viewport size;
};

/// The ground behind a model in the window's light colours.
[[nodiscard]] render::Background light_background();

/// How frames look.
struct FrameLook {
  geometry::Camera camera;
  bool moves = false;  ///< the camera that the document has on its timeline is taken, and `camera` only its size
  std::optional<PxPart> part{};  ///< of what the camera shows; nothing: all of it
  bool wireframe = false;
  bool matcap = false;           ///< render::Scene::matcap
  bool clay = false;             ///< without textures and colours of vertices
  bool light = false;            ///< on light_background()
  FilmGhosts* ghosts = nullptr;  ///< the face before and after; null: it is not shown
};

/// Another character that is filmed beside one.
struct Beside {
  document::Document document;
  geometry::Placement placement;  ///< seen from the one
  render::Appearance appearance;
};

/// The frames of a document's timeline or, where nothing is keyed, of its model's first animation. A camera that is
/// keyed is enough.
class FilmFrames {
 public:
  /// Errors: of none anything is keyed, and no model has an animation.
  static base::Result<FilmFrames> make(document::Document document, double rate, std::vector<Beside> others = {});

  /// The number of the last frame that anything is keyed on.
  [[nodiscard]] int last() const;
  /// The frames that are keyed, ascending.
  [[nodiscard]] std::vector<int> keyed() const;
  [[nodiscard]] const document::Document& document() const { return document_; }
  [[nodiscard]] double rate() const { return rate_; }
  /// The model as it is at a frame. Errors of the rig.
  [[nodiscard]] base::Result<document::Model> at(int frame) const;
  /// What the camera of the timeline shows at a frame in a part of a picture; nothing: no camera is keyed.
  [[nodiscard]] std::optional<geometry::Camera> camera_at(int frame, geometry::Viewport whole,
                                                          const std::optional<PxPart>& part) const;
  /// Those beside it, and one of them as it is at a frame.
  [[nodiscard]] const std::vector<Beside>& others() const { return others_; }
  [[nodiscard]] base::Result<document::Model> other_at(std::size_t other, int frame) const;

 private:
  FilmFrames() = default;
  [[nodiscard]] std::vector<const document::Document*> all() const;

  document::Document document_;
  std::vector<Beside> others_;
  double rate_ = 24;
};

/// Draws a frame. Errors: of the rig and the renderer.
[[nodiscard]] base::Result<render::Image> draw_frame(const FilmFrames& frames, int frame, render::Renderer& renderer,
                                                     const render::Appearance& appearance, const FrameLook& look);

/// A part of a picture. Precondition: it lies inside.
[[nodiscard]] render::Image part_of(const render::Image& image, const PxPart& part);

}  // namespace penpose::film
