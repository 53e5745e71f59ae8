// In place of ui/app/view/present/gl where the program is built without OpenGL (PENPOSE_GL=OFF).

#include "ui/app/view/present/presenter.h"

namespace penpose::app {

// Not called: no context is made without OpenGL (ui/render/absent/no_gl.cpp).
std::unique_ptr<Presenter> make_gl_presenter(SDL_Window*, void*, render::DrawWay) { return nullptr; }

}  // namespace penpose::app
