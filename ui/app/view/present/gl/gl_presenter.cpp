#include <SDL2/SDL.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "ui/app/view/present/gl/drawable_size.h"
#include "ui/app/view/present/presenter.h"
#include "ui/render/gl/gl_renderer.h"
#include "ui/render/gl/offscreen_context.h"

namespace penpose::app {
namespace {

bool draws_in_software(const std::string& driver) {
  return driver.find("llvmpipe") != std::string::npos || driver.find("softpipe") != std::string::npos ||
         driver.find("SWR") != std::string::npos;
}

class GlPresenter final : public Presenter {
 public:
  GlPresenter(SDL_Window* window, void* context) : window_(window), context_(context) {}

  base::Status begin() override {
    if (SDL_GL_MakeCurrent(window_, context_) != 0) {
      return base::Error{"OpenGL could not be used on another thread", "", "try another driver"};
    }
    SDL_GL_SetSwapInterval(1);
    auto renderer = render::GlRenderer::make_in_current_context();
    if (!renderer) return renderer.error();
    // Darkening of creases would cost the pen its frames where there is no graphics card, and edges averaged from
    // several samples 30 MB and half of its speed; they are smoothed when nothing moves.
    const bool software = draws_in_software((*renderer)->driver());
    (*renderer)->set_occlusion(!software);
    (*renderer)->set_smoothing(software);
    if (!ImGui_ImplOpenGL3_Init("#version 140")) {
      return base::Error{"the panels could not be started", "", "install libgl1 and libgl1-mesa-dri"};
    }
    ImGui_ImplOpenGL3_NewFrame();
    renderer_ = std::move(*renderer);
    return base::Done{};
  }

  void end() override {
    if (renderer_) ImGui_ImplOpenGL3_Shutdown();
    renderer_.reset();
    SDL_GL_MakeCurrent(window_, nullptr);
  }

  base::Status draw(const DrawFrame& frame, ImDrawData& panels) override {
    renderer_->set_behind(frame.behind);
    const auto camera = geometry::Camera::make(frame.view.camera, frame.view.viewport);
    if (!camera) return camera.error();
    if (auto drawn = renderer_->draw(scene_of(frame), *camera, 0, 0, 0); !drawn) return drawn;
    ImGui_ImplOpenGL3_RenderDrawData(&panels);
    return base::Done{};
  }

  void show() override {
    SDL_GL_SwapWindow(window_);
    drawable_ = drawable_size();
  }

  void send_letters() override {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }

  [[nodiscard]] bool refining() const override { return renderer_->refining(); }
  [[nodiscard]] std::vector<std::string> take_undrawn() override { return renderer_->take_undrawn(); }
  [[nodiscard]] std::optional<geometry::Viewport> drawable() const override { return drawable_; }

 private:
  SDL_Window* window_;
  void* context_;
  std::unique_ptr<render::GlRenderer> renderer_;
  std::optional<geometry::Viewport> drawable_;
};

}  // namespace

base::Status check_gl() {
  if (const auto room = render::check_room_for_gl(); !room) return room;
  return render::check_threads_for_gl();
}

std::unique_ptr<Presenter> make_gl_presenter(SDL_Window* window, void* context) {
  return std::make_unique<GlPresenter>(window, context);
}

}  // namespace penpose::app
