#include "ui/render/offscreen_ways.h"

#include "ui/render/gl/gl_renderer.h"

namespace penpose::render {

namespace {

template <DrawWay way>
base::Result<std::unique_ptr<Renderer>> make_offscreen() {
  auto made = GlRenderer::make_offscreen(way);
  if (!made) return made.error();
  return std::unique_ptr<Renderer>(std::move(*made));
}

}  // namespace

std::vector<OffscreenWay> card_ways() {
  return {{DrawWay::gl, make_offscreen<DrawWay::gl>}, {DrawWay::es, make_offscreen<DrawWay::es>}};
}

}  // namespace penpose::render
