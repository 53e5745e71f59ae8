// In place of ui/app/view/present/gl where the program is built without OpenGL (PENPOSE_GL=OFF).

#include "ui/app/view/present/presenter.h"

namespace penpose::app {

base::Status check_gl() { return base::Error{"this penpose was built without OpenGL", "", "draw with --draw cpu"}; }
std::unique_ptr<Presenter> make_gl_presenter(SDL_Window*, void*) { return nullptr; }

}  // namespace penpose::app
