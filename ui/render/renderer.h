#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/interface.h"
#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "ui/render/behind.h"
#include "ui/render/picture/image.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// How pictures are drawn: by OpenGL 3.1 or OpenGL ES 3.0, by OpenGL ES 2.0 or OpenGL 2.1, by the processor.
enum class DrawWay : std::uint8_t { gl, es, cpu };
/// As users write it: "gl", "es", "cpu".
[[nodiscard]] std::string_view name_of(DrawWay way);
[[nodiscard]] std::optional<DrawWay> way_of(std::string_view name);
/// The ways that this program was built with, the best first.
[[nodiscard]] std::vector<DrawWay> built_in_ways();

/// Draws scenes. One thread only: the one that made it.
class Renderer : public base::Interface {
 public:
  /// The picture that the camera's viewport shows. Works for models of any size and unit. Errors: arrays that do not
  /// fit each other, or a picture larger than the driver can draw.
  virtual base::Result<Image> render(const Scene& scene, const geometry::Camera& camera) = 0;
  /// A picture behind the model in all pictures from now on.
  virtual void set_behind(Behind behind) = 0;
  /// A translucent picture over the model and under the curves in all pictures from now on, half as wide and high as
  /// they are, straight alpha (ghost_veil); null: none.
  virtual void set_veil(std::shared_ptr<const Image> veil) = 0;
  /// Darkening of creases; costs the most of a picture on a weak graphics card.
  virtual void set_occlusion(bool on) = 0;
  /// On: a picture has one sample a px, and pictures of what does not change are averaged, each moved by a part of a
  /// px, so that edges are smooth a few pictures after the last change. Off: eight samples a px. Counts before the
  /// first picture.
  virtual void set_smoothing(bool on) = 0;
  /// Whether the next picture of the same scene would be smoother.
  [[nodiscard]] virtual bool refining() const = 0;
  /// Pictures of models that could not be unpacked and so were drawn grey, "NAME (why)" as Look::undrawn; each is told
  /// once.
  [[nodiscard]] virtual std::vector<std::string> take_undrawn() = 0;
  /// Name and version of what draws, for messages.
  [[nodiscard]] virtual std::string driver() const = 0;
};

/// What draws by a way without a window, or why nothing does.
struct WayHere {
  DrawWay way = DrawWay::cpu;
  base::Result<std::string> driver;
};
/// Tries each of `built_in_ways`.
[[nodiscard]] std::vector<WayHere> ways_here();

/// A renderer without a window, a display or a graphics card: of the way asked for, or else the first of
/// `built_in_ways` that starts. Errors: the way asked for is not built in or does not start.
[[nodiscard]] base::Result<std::unique_ptr<Renderer>> make_offscreen_renderer(
    std::optional<DrawWay> way = std::nullopt);

}  // namespace penpose::render
