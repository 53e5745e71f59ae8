#include "ui/render/gl/mesh/textures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <epoxy/gl.h>
#include <utility>

namespace penpose::render {
namespace {

constexpr std::uint64_t k_most_texture_px = 9'600'000;

int power_of_two_near(int size) {
  int power = 1;
  while (power * 3 < size * 2) power *= 2;
  return power;
}

/// With sides that are powers of two.
Image with_even_sides(Image image) {
  const Image source = std::move(image);
  Image made{power_of_two_near(source.width), power_of_two_near(source.height), {}};
  if (made.width == source.width && made.height == source.height) return source;
  made.pixels.reserve(static_cast<std::size_t>(made.width) * static_cast<std::size_t>(made.height) * 4);
  struct Between {
    int first = 0;
    int second = 0;
    float share = 0;
  };
  const auto between = [](int at, int from, int to) {
    const float place = (static_cast<float>(at) + 0.5F) * static_cast<float>(to) / static_cast<float>(from) - 0.5F;
    const float floor = std::floor(place);
    const int first = static_cast<int>(floor);
    return Between{std::clamp(first, 0, to - 1), std::clamp(first + 1, 0, to - 1), place - floor};
  };
  for (int y = 0; y < made.height; ++y) {
    const Between row = between(y, made.height, source.height);
    for (int x = 0; x < made.width; ++x) {
      const Between column = between(x, made.width, source.width);
      for (int c = 0; c < 4; ++c) {
        const auto mixed = [&](int line) {
          return static_cast<float>(source.at(column.first, line)[c]) * (1 - column.share) +
                 static_cast<float>(source.at(column.second, line)[c]) * column.share;
        };
        const float value = mixed(row.first) * (1 - row.share) + mixed(row.second) * row.share;
        made.pixels.push_back(static_cast<std::uint8_t>(value + 0.5F));
      }
    }
  }
  return made;
}

unsigned send(const Image& image, bool modern) {
  unsigned name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, modern ? GL_SRGB8_ALPHA8 : GL_RGBA, image.width, image.height, 0, GL_RGBA,
               GL_UNSIGNED_BYTE, image.pixels.data());
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
  pictures_.keep(look, batches, k_most_texture_px, [this](Image image) {
    return Texture(modern_ ? send(image, true) : send(with_even_sides(std::move(image)), false));
  });
  glBindTexture(GL_TEXTURE_2D, 0);
}

bool Textures::bind(const document::Look& look, const document::TextureUse& use, unsigned unit) const {
  const Texture* texture = pictures_.find(look, use);
  if (texture == nullptr) return false;
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture->name());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, use.nearest ? GL_NEAREST : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(use.wrap_u));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(use.wrap_v));
  return true;
}

}  // namespace penpose::render
