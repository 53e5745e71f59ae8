#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ui/app/files/player.h"
#include "ui/app/notices.h"
#include "ui/app/preferences.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/view/area.h"
#include "ui/app/view/backdrop.h"
#include "ui/app/view/posed_surface.h"
#include "ui/render/framing.h"
#include "ui/render/ghosts/ghost_moments.h"
#include "ui/render/scene.h"

namespace penpose::app {

/// How the canvas is shown. Nothing of it is saved; the picture is what the document refers to.
struct CanvasLook {
  bool wireframe = false;
  bool clay = false;         ///< without textures and colours of the file
  bool matcap = false;       ///< without them and lit as a ball is; never together with clay
  bool onion_skin = false;   ///< the face at other moments
  render::GhostLook ghosts;  ///< at which ones, and how
  bool ghosts_in_films = false;
  bool fullscreen = false;             ///< of the window
  std::shared_ptr<Backdrop> backdrop;  ///< a picture that one animates after; null: none
};

/// What the canvas shows over the model, as of the last frame.
struct CanvasDrawing {
  std::vector<render::CurveDrawing> curves;
  std::shared_ptr<const render::Image> veil;  ///< of ghosts; null: none
};

/// Degrees about +y by which a document's own front stands away from +z: as it was set, else as the file has it.
[[nodiscard]] double front_degrees(const document::Document& document);

/// The model as it is seen: the window's size, the part that panels leave free, the camera, the posed surface.
/// Coordinates are px of the window.
class Canvas {
 public:
  Canvas(EditingSession& editing, Preferences& preferences, Notices& notices, const Player& player);

  // The place of it.
  /// `dpi` of the display; 0: not known. `own`: px for each px of an ordinary one, as the system wants it
  /// (own_scale.h); 0: by the density.
  void resized(geometry::Viewport window, double dpi, double own = 0);
  /// Asks for a scale, whatever the settings and the system say; what is made larger or smaller later counts from
  /// there. 0: does not.
  void ask_scale(double scale);
  [[nodiscard]] geometry::Viewport window() const { return window_; }
  /// Px of the display for each px of an ordinary one.
  [[nodiscard]] double scale() const;
  /// Px of a target that a finger or a pen hits for certain: 9 mm.
  [[nodiscard]] double target_px() const;
  /// The part of the window that no panel covers.
  [[nodiscard]] const Area& free_area() const { return free_; }
  void set_free_area(const Area& area);
  [[nodiscard]] PosedSurface& surface() { return surface_; }
  [[nodiscard]] const PosedSurface& surface() const { return surface_; }

  // The camera.
  /// As it is shown now.
  [[nodiscard]] const document::View& view() const { return view_; }
  /// Makes it the view of the strokes to come, unless one is being drawn or a session is played.
  void commit();
  /// Another camera; the view frames the model no longer.
  void set_camera(const geometry::CameraPose& camera);
  /// The camera that a session is played with.
  void show_played();
  /// Looks at all of the model from where one looks.
  void frame_all();
  /// Looks at points from where one looks.
  void frame_points(std::span<const glm::vec3> points);
  /// Looks at the face from where one looks; at all of a model that is nothing but a face.
  void frame_face();
  /// Looks at another model from its front: at the face of a whole figure, else at all of it.
  void begin();
  /// Degrees about the model.
  void turn(double yaw, double pitch);
  void zoom(double factor, PxPoint about);
  void pan(PxPoint by);
  /// Looks from a direction by the model's own front; a view that was zoomed into stays as near as it is.
  void look_from(const render::Viewpoint& viewpoint);
  /// The direction in which one looks, by the model's own front.
  [[nodiscard]] render::Viewpoint looking_from() const;
  /// What is seen from here is the model's front from now on.
  void set_front();
  /// With perspective or without.
  [[nodiscard]] bool flat() const;
  void set_flat(bool on);

 private:
  void frame_from(const render::Viewpoint& from);
  [[nodiscard]] double dpi() const;
  /// Without what was chosen in the settings.
  [[nodiscard]] double base_scale() const;

  EditingSession& editing_;
  Preferences& preferences_;
  Notices& notices_;
  const Player& player_;
  PosedSurface surface_;
  geometry::Viewport window_{1280, 800};
  double dpi_ = 96;
  double own_scale_ = 0;
  double asked_scale_ = 0;  ///< without what was chosen in the settings; 0: none
  Area free_{0, 0, 1280, 800};
  document::View view_;
  render::Viewpoint viewpoint_;
  bool frames_face_ = false;  ///< where it frames, the face and not all
  bool framed_ = false;       ///< the view still frames the model: it follows the window's size
};

}  // namespace penpose::app
