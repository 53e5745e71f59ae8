#include "ui/render/gl/screen_fill.h"

#include <array>
#include <epoxy/gl.h>

#include "ui/render/gl/vertex_data.h"

namespace penpose::render {

ScreenFill::ScreenFill(const GlDialect& dialect) : array_(dialect) {
  constexpr std::array<float, 6> k_corners{-1, -1, 3, -1, -1, 3};
  glGenBuffers(1, &corners_);
  fill(GL_ARRAY_BUFFER, corners_, std::span<const float>(k_corners), GL_STATIC_DRAW);
  array_.set({0, corners_, 2, GL_FLOAT, 8, 0});
  array_.unbind();
}

ScreenFill::~ScreenFill() { glDeleteBuffers(1, &corners_); }

void ScreenFill::draw() const {
  array_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  array_.unbind();
}

}  // namespace penpose::render
