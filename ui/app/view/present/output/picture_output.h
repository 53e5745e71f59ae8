#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/interface.h"
#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "ui/render/cpu/triangles/triangle_raster.h"
#include "ui/render/picture/image.h"

struct SDL_Window;

namespace penpose::app {

/// Where pictures that the processor drew are put. Made on any thread, used on one.
class PictureOutput : public base::Interface {
 public:
  /// Px, as of now; nothing while it cannot be asked.
  [[nodiscard]] virtual std::optional<geometry::Viewport> size() const = 0;
  /// Px per inch as the panel says it; 0: it does not.
  [[nodiscard]] virtual double dpi() const = 0;
  /// Puts these parts of a picture there, the rest stays as it was; all of it where there was none. What of the picture
  /// lies outside is left out. Comes back when the next may follow.
  virtual void show(const render::Image& picture, const std::vector<render::PxRect>& parts) = 0;
};

/// The px of a window, which must outlive it.
[[nodiscard]] std::unique_ptr<PictureOutput> make_window_output(SDL_Window* window);

/// A whole screen of the machine that no desktop has: by the kernel's display driver (/dev/dri), else its frame buffer
/// (/dev/fb0). `screen` counts from 0 those that are connected, the first by default; `slow`: parts are put there as
/// they come, never whole pictures in turn. What was on the screen before comes back at the end. Errors: there is none,
/// it may not be opened, or another program has it.
[[nodiscard]] base::Result<std::unique_ptr<PictureOutput>> open_screen_output(std::optional<int> screen, bool slow);

}  // namespace penpose::app
