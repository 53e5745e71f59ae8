#pragma once

#include <memory>
#include <optional>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "core/geometry/space.h"
#include "ui/app/view/present/output/picture_output.h"
#include "ui/app/view/present/output/rotation.h"
#include "ui/app/view/present/presenter.h"
#include "ui/app/window/input_nodes.h"
#include "ui/files/window_request.h"
#include "ui/render/renderer.h"

struct SDL_Window;
struct SDL_Rect;

namespace penpose::app {

/// The screen that the window is on: a desktop's, or the machine's own, which OpenGL or the processor fills. Which one,
/// how it is turned and how dense it is. Places are px.
class Screen {
 public:
  explicit Screen(const files::WindowRequest& request);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// The way that this screen is drawn by whatever is asked for: a turned or slow one by the processor. Nothing: any.
  [[nodiscard]] std::optional<render::DrawWay> only_way() const;
  /// Starts SDL's video for a way to draw. Errors: there is no display.
  base::Status start(render::DrawWay way);
  /// Where a window of a usual size, or one that fills the screen, is opened.
  [[nodiscard]] SDL_Rect place_of_window(bool fills) const;
  /// Call it when the window is there, which must outlive this.
  void take(SDL_Window* window);
  /// Whether a mouse, a keyboard or a touch panel came that SDL does not hear of, as on a bare board without udev.
  /// Starting anew finds it.
  [[nodiscard]] bool lacks_input();
  /// By the processor, in the window or on the screen itself.
  [[nodiscard]] std::unique_ptr<Presenter> cpu_presenter();

  [[nodiscard]] bool slow() const { return slow_; }
  /// No system draws the mouse's pointer here.
  [[nodiscard]] bool lacks_pointer() const { return bare_output_; }
  /// The size of the picture.
  [[nodiscard]] geometry::Viewport size() const { return turned_size(panel(), rotation_); }
  [[nodiscard]] double dpi() const;
  /// As the desktop wants it (ui/app/canvas/own_scale.h); 0: it says nothing, or its density was given by hand.
  [[nodiscard]] double own_scale() const;
  /// The place on the picture of the mouse that moved to a place by an amount, in SDL's units of the window.
  [[nodiscard]] geometry::PxPoint moved_mouse(geometry::PxPoint to, geometry::PxPoint by);
  /// The same of the mouse where SDL says that it is, and of a finger, in shares of the window's size.
  [[nodiscard]] geometry::PxPoint of_mouse(double x, double y) const;
  [[nodiscard]] geometry::PxPoint of_finger(double x, double y) const;

 private:
  [[nodiscard]] geometry::Viewport panel() const;
  /// Of one of SDL's displays; 0: it is not known.
  [[nodiscard]] double display_dpi(int index) const;
  /// Px of a window that is opened for each px of an ordinary one; out of 0.5..4: not known.
  [[nodiscard]] double opening_scale(int index) const;
  /// own_scale() of a window with so many px for each of its units.
  [[nodiscard]] double desktop_scale(double px_a_unit) const;

  std::optional<int> wanted_;
  Rotation rotation_;
  Rotation finger_rotation_;  ///< none where the system turns fingers itself
  double wanted_dpi_;
  double wanted_scale_;  ///< 0: none
  bool slow_;
  bool bare_;                 ///< there is no desktop
  bool bare_output_ = false;  ///< `output_` is a whole screen
  double bare_dpi_ = 0;
  bool on_x_ = false;             ///< the desktop is an X server
  double text_dpi_ = 0;           ///< of its resources; 0: none
  double server_dpi_ = 0;         ///< that it was started with; 0: none
  geometry::PxPoint bare_mouse_;  ///< on the panel, where `bare_output_`
  std::unique_ptr<PictureOutput> output_;
  SDL_Window* window_ = nullptr;
  InputNodes inputs_;
};

}  // namespace penpose::app
