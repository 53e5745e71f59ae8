#include <SDL2/SDL.h>
#include <atomic>
#include <chrono>
#include <thread>

#include "ui/app/view/present/output/picture_output.h"
#include "ui/app/view/present/output/px_copy.h"

namespace penpose::app {
namespace {

/// Nothing tells when the screen is done with a picture; more than 60 a second are never seen.
constexpr std::chrono::microseconds k_least_between{16'000};

class WindowOutput final : public PictureOutput {
 public:
  explicit WindowOutput(SDL_Window* window) : window_(window) { SDL_AddEventWatch(look_at, this); }
  ~WindowOutput() override { SDL_DelEventWatch(look_at, this); }
  WindowOutput(const WindowOutput&) = delete;
  WindowOutput& operator=(const WindowOutput&) = delete;

  [[nodiscard]] std::optional<geometry::Viewport> size() const override { return size_; }
  [[nodiscard]] double dpi() const override { return 0; }

  void show(const render::Image& picture, const std::vector<render::PxRect>& parts) override {
    std::this_thread::sleep_until(shown_ + k_least_between);
    shown_ = std::chrono::steady_clock::now();
    SDL_Surface* surface = SDL_GetWindowSurface(window_);
    if (surface == nullptr || SDL_LockSurface(surface) != 0) return;
    const geometry::Viewport size{surface->w, surface->h};
    // A window that has just changed its size shows what there is of it.
    const bool anew = exposed_.exchange(false) || !(size_ == size);
    size_ = size;
    const PxMemory there{static_cast<std::uint8_t*>(surface->pixels), surface->pitch, surface->format->format, size};
    std::vector<SDL_Rect> put;
    for (const render::PxRect& part : anew ? std::vector{render::PxRect{0, 0, picture.width, picture.height}} : parts) {
      const render::PxRect inside = copy_px(picture, part, there);
      if (!inside.empty())
        put.push_back({inside.left, inside.top, inside.right - inside.left, inside.bottom - inside.top});
    }
    SDL_UnlockSurface(surface);
    if (!put.empty()) SDL_UpdateWindowSurfaceRects(window_, put.data(), static_cast<int>(put.size()));
  }

 private:
  /// What another window covered has to be put there again.
  static int look_at(void* self, SDL_Event* event) {
    if (event->type == SDL_WINDOWEVENT && event->window.event == SDL_WINDOWEVENT_EXPOSED)
      static_cast<WindowOutput*>(self)->exposed_ = true;
    return 0;
  }

  SDL_Window* window_;
  std::atomic<bool> exposed_{false};
  std::chrono::steady_clock::time_point shown_;
  std::optional<geometry::Viewport> size_;
};

}  // namespace

std::unique_ptr<PictureOutput> make_window_output(SDL_Window* window) { return std::make_unique<WindowOutput>(window); }

}  // namespace penpose::app
