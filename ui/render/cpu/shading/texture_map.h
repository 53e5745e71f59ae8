#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "core/document/look.h"
#include "ui/render/picture/image.h"

namespace penpose::render {

/// A picture that lies on a surface, with its smaller ones down to 1 x 1.
class TextureMap {
 public:
  explicit TextureMap(Image image);

  /// Linear light and alpha at a place, filtered between places and sizes as OpenGL does with GL_LINEAR_MIPMAP_LINEAR;
  /// `along_x`, `along_y`: how the place changes by a px of the screen.
  [[nodiscard]] glm::vec4 sample(const document::TextureUse& use, const glm::vec2& at, const glm::vec2& along_x,
                                 const glm::vec2& along_y) const;

 private:
  [[nodiscard]] glm::vec4 sample_level(const document::TextureUse& use, std::size_t level, const glm::vec2& at,
                                       bool nearest) const;

  std::vector<Image> levels_;
};

}  // namespace penpose::render
