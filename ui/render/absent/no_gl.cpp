// What the window asks of ui/render/gl, where the program is built without OpenGL (PENPOSE_GL=OFF).

#include "ui/render/gl/gl_dialect.h"
#include "ui/render/gl/offscreen_context.h"

namespace penpose::render {

base::Status check_room_for_gl() {
  return base::Error{"this penpose was built without OpenGL", "", "draw with --draw cpu"};
}
base::Status check_threads_for_gl() { return check_room_for_gl(); }
std::span<const GlVersion> versions_of(DrawWay) { return {}; }
std::string needs_of(DrawWay) { return "OpenGL"; }

}  // namespace penpose::render
