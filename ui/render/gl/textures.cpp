#include "ui/render/gl/textures.h"

#include <epoxy/gl.h>

namespace penpose::render {
namespace {

constexpr std::uint64_t k_most_px = 9'600'000;

unsigned send(const Image& image) {
  unsigned name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.pixels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  return name;
}

GLint wrap_of(document::Wrap wrap) {
  return wrap == document::Wrap::clamp    ? GL_CLAMP_TO_EDGE
         : wrap == document::Wrap::mirror ? GL_MIRRORED_REPEAT
                                          : GL_REPEAT;
}

}  // namespace

Textures::Texture::~Texture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

void Textures::keep(const document::Look& look, std::span<const LookBatch> batches) {
  pictures_.keep(look, batches, k_most_px, [](const Image& image) { return Texture(send(image)); });
  glBindTexture(GL_TEXTURE_2D, 0);
}

bool Textures::bind(const document::Look& look, const document::TextureUse& use) const {
  const Texture* texture = pictures_.find(look, use);
  if (texture == nullptr) return false;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture->name());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, use.nearest ? GL_NEAREST : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(use.wrap_u));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(use.wrap_v));
  return true;
}

}  // namespace penpose::render
