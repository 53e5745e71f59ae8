// In place of OpenGL where the program is built without it (PENPOSE_WINDOW=OFF): every picture is an error that says
// so.

#include "ui/render/gl/renderer.h"

namespace penpose::render {
namespace {

base::Error no_pictures() {
  return {"this penpose draws no pictures: it was built without OpenGL", "",
          "draw them on a machine that has the package penpose in place of penpose-nogui"};
}

}  // namespace

struct Renderer::State {};

bool Renderer::is_built_in() { return false; }
base::Result<std::unique_ptr<Renderer>> Renderer::make_offscreen() { return no_pictures(); }
Renderer::~Renderer() = default;
std::vector<std::string> Renderer::take_undrawn() { return {}; }
base::Result<Image> Renderer::render(const Scene&, const geometry::Camera&) { return no_pictures(); }

}  // namespace penpose::render
