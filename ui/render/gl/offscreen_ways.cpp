#include "ui/render/offscreen_ways.h"

#include "ui/render/gl/gl_renderer.h"

namespace penpose::render {

std::vector<OffscreenWay> card_ways() {
  return {{DrawWay::gl, []() -> base::Result<std::unique_ptr<Renderer>> {
             auto made = GlRenderer::make_offscreen();
             if (!made) return made.error();
             return std::unique_ptr<Renderer>(std::move(*made));
           }}};
}

}  // namespace penpose::render
