#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "ui/render/gl/behind_pass.h"
#include "ui/render/picture/image.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// Draws scenes with OpenGL 3.1 or OpenGL ES 3.0. One thread only: the one that made it.
class Renderer {
 public:
  /// Whether the program can draw pictures at all; where it is built without OpenGL every maker is an error.
  [[nodiscard]] static bool is_built_in();
  /// A renderer without a window, a display or a graphics card. Errors: there is no OpenGL at all.
  static base::Result<std::unique_ptr<Renderer>> make_offscreen();
  /// A renderer in the context that is current now and stays so. Errors: older than OpenGL 3.1 / ES 3.0.
  static base::Result<std::unique_ptr<Renderer>> make_in_current_context();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// The picture that the camera's viewport shows. Works for models of any size and unit. Errors: arrays that do not
  /// fit each other, or a picture larger than the driver can draw.
  base::Result<Image> render(const Scene& scene, const geometry::Camera& camera);
  /// The same into a framebuffer of the current context (0: the window), its lower left corner at x, y px. Leaves the
  /// bound program, arrays, viewport, depth test and blending changed.
  base::Status draw(const Scene& scene, const geometry::Camera& camera, unsigned framebuffer = 0, int x = 0, int y = 0);

  /// A picture behind the model in all pictures from now on.
  void set_behind(Behind behind);
  /// Darkening of creases; costs the most of a picture on a weak graphics card.
  void set_occlusion(bool on);
  /// Samples a pixel, 8 at most; each costs its memory, and time on a software renderer. Counts before the first
  /// picture.
  void set_most_samples(int most);
  /// With one sample a pixel: pictures of what does not change are averaged, each moved by a part of a px, so that
  /// edges are smooth a few pictures after the last change.
  void set_smoothing(bool on);
  /// Pictures of models that could not be unpacked and so were drawn grey, "NAME (why)" as Look::undrawn; each is told
  /// once.
  [[nodiscard]] std::vector<std::string> take_undrawn();
  /// Whether the next picture of the same scene would be smoother.
  [[nodiscard]] bool refining() const;
  /// Name and version of the driver, for messages.
  [[nodiscard]] std::string driver() const;

 private:
  struct State;
  explicit Renderer(std::unique_ptr<State> state);
  base::Status draw_picture(const Scene& scene, const geometry::Camera& camera);

  std::unique_ptr<State> state_;
};

}  // namespace penpose::render
