#include <SDL2/SDL.h>
#include <imgui.h>

#include "ui/app/view/present/gl/drawable_size.h"
#include "ui/app/view/present/gl/gl_panels.h"
#include "ui/app/view/present/presenter.h"
#include "ui/render/gl/gl_dialect.h"
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
  GlPresenter(SDL_Window* window, void* context, render::DrawWay way) : window_(window), context_(context), way_(way) {}

  base::Status begin() override {
    if (SDL_GL_MakeCurrent(window_, context_) != 0) {
      return base::Error{"OpenGL could not be used on another thread", "", "draw with --draw cpu"};
    }
    SDL_GL_SetSwapInterval(1);
    auto renderer = render::GlRenderer::make_in_current_context(way_);
    if (!renderer) return renderer.error();
    // Darkening of creases would cost the pen its frames where there is no graphics card, and edges averaged from
    // several samples 30 MB and half of its speed; they are smoothed when nothing moves.
    const bool weak = way_ == render::DrawWay::es || draws_in_software((*renderer)->driver());
    (*renderer)->set_occlusion(!weak);
    (*renderer)->set_smoothing(weak);
    auto panels = GlPanels::make((*renderer)->dialect());
    if (!panels) return panels.error();
    panels_.emplace(std::move(*panels));
    panels_->send_letters();
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    renderer_ = std::move(*renderer);
    return base::Done{};
  }

  void end() override {
    panels_.reset();
    renderer_.reset();
    SDL_GL_MakeCurrent(window_, nullptr);
  }

  base::Status draw(const DrawFrame& frame, ImDrawData& panels) override {
    renderer_->set_behind(frame.behind);
    renderer_->set_veil(frame.veil);
    const auto camera = geometry::Camera::make(frame.view.camera, frame.view.viewport);
    if (!camera) return camera.error();
    if (auto drawn = renderer_->draw(scene_of(frame), *camera, 0, 0, 0); !drawn) return drawn;
    panels_->draw(panels);
    return base::Done{};
  }

  void show() override {
    SDL_GL_SwapWindow(window_);
    drawable_ = drawable_size();
  }

  void send_letters() override { panels_->send_letters(); }

  [[nodiscard]] bool refining() const override { return renderer_->refining(); }
  [[nodiscard]] std::vector<std::string> take_undrawn() override { return renderer_->take_undrawn(); }
  [[nodiscard]] std::optional<geometry::Viewport> drawable() const override { return drawable_; }

 private:
  SDL_Window* window_;
  void* context_;
  render::DrawWay way_;
  std::unique_ptr<render::GlRenderer> renderer_;
  std::optional<GlPanels> panels_;
  std::optional<geometry::Viewport> drawable_;
};

}  // namespace

base::Result<GlWindow> open_gl_window(render::DrawWay way,
                                      const std::function<SDL_Window*(std::uint32_t flags)>& open) {
  if (const auto room = render::check_room_for_gl(); !room) return room.error();
  if (const auto threads = render::check_threads_for_gl(); !threads) return threads.error();
  // The picture is averaged before it reaches the window, which needs no depth of its own.
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
  bool refused = false;
  for (const render::GlVersion& version : render::versions_of(way)) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, version.profile);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, version.major);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, version.minor);
    GlWindow made;
    made.window = open(SDL_WINDOW_OPENGL);
    if (made.window == nullptr) continue;
    made.context = SDL_GL_CreateContext(made.window);
    if (made.context != nullptr) return made;
    SDL_DestroyWindow(made.window);
    refused = true;
  }
  std::string why = SDL_GetError();
  why = why.empty() ? "no reason given" : why.substr(0, why.find('\n'));
  // Where there is a window there is a driver.
  if (refused) return render::less_than(way, why);
  return base::Error{render::needs_of(way) + " could not be started (" + why + ")", "",
                     "install libgl1 and libgl1-mesa-dri, or draw with --draw cpu"};
}

std::unique_ptr<Presenter> make_gl_presenter(const GlWindow& window, render::DrawWay way) {
  SDL_GL_MakeCurrent(window.window, nullptr);
  return std::make_unique<GlPresenter>(window.window, window.context, way);
}

}  // namespace penpose::app
