// In place of ui/app/view/present/gl where the program is built without OpenGL (PENPOSE_GL=OFF).

#include "ui/app/view/present/presenter.h"

namespace penpose::app {

base::Result<GlWindow> open_gl_window(render::DrawWay, const std::function<SDL_Window*(std::uint32_t flags)>&) {
  return base::Error{"this penpose was built without OpenGL", "", "draw with --draw cpu"};
}
std::unique_ptr<Presenter> make_gl_presenter(const GlWindow&, render::DrawWay) { return nullptr; }

}  // namespace penpose::app
