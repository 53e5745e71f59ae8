#include <SDL2/SDL.h>
#include <chrono>
#include <thread>

#include "ui/app/view/present/panel_painter.h"
#include "ui/app/view/present/presenter.h"
#include "ui/render/cpu/cpu_renderer.h"

namespace penpose::app {
namespace {

/// Nothing tells when the screen is done with a picture; more than 60 a second are never seen.
constexpr std::chrono::microseconds k_least_between{16'000};

class CpuPresenter final : public Presenter {
 public:
  explicit CpuPresenter(SDL_Window* window) : window_(window) {}

  base::Status begin() override {
    renderer_ = std::make_unique<render::CpuRenderer>();
    // Darkening of creases would cost the pen its frames; edges are smoothed when nothing moves.
    renderer_->set_occlusion(false);
    renderer_->set_smoothing(true);
    return base::Done{};
  }

  void end() override { renderer_.reset(); }

  base::Status draw(const DrawFrame& frame, ImDrawData& panels) override {
    renderer_->set_behind(frame.behind);
    const auto camera = geometry::Camera::make(frame.view.camera, frame.view.viewport);
    if (!camera) return camera.error();
    if (auto drawn = renderer_->draw(scene_of(frame), *camera, picture_); !drawn) return drawn;
    paint_panels(panels, picture_);
    return base::Done{};
  }

  void show() override {
    std::this_thread::sleep_until(shown_ + k_least_between);
    shown_ = std::chrono::steady_clock::now();
    SDL_Surface* surface = SDL_GetWindowSurface(window_);
    if (surface == nullptr || SDL_LockSurface(surface) != 0) return;
    // A window that has just changed its size shows what there is of it.
    const int width = std::min(surface->w, picture_.width);
    const int height = std::min(surface->h, picture_.height);
    SDL_ConvertPixels(width, height, SDL_PIXELFORMAT_RGBA32, picture_.pixels.data(), picture_.width * 4,
                      surface->format->format, surface->pixels, surface->pitch);
    SDL_UnlockSurface(surface);
    SDL_UpdateWindowSurface(window_);
    drawable_ = geometry::Viewport{surface->w, surface->h};
  }

  void send_letters() override {}  // they are read where ImGui has them

  [[nodiscard]] bool refining() const override { return renderer_->refining(); }
  [[nodiscard]] std::vector<std::string> take_undrawn() override { return renderer_->take_undrawn(); }
  [[nodiscard]] std::optional<geometry::Viewport> drawable() const override { return drawable_; }

 private:
  SDL_Window* window_;
  std::unique_ptr<render::CpuRenderer> renderer_;
  render::Image picture_;
  std::chrono::steady_clock::time_point shown_;
  std::optional<geometry::Viewport> drawable_;
};

}  // namespace

std::unique_ptr<Presenter> make_cpu_presenter(SDL_Window* window) { return std::make_unique<CpuPresenter>(window); }

}  // namespace penpose::app
