#include "ui/render/gl/framebuffers.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <string>

namespace penpose::render {
namespace {

unsigned make_texture(int internal, unsigned format, unsigned type, int width, int height) {
  unsigned texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

unsigned make_renderbuffer(unsigned format, int samples, int width, int height) {
  unsigned buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return buffer;
}

unsigned make_target(unsigned color, unsigned depth) {
  unsigned target = 0;
  glGenFramebuffers(1, &target);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
  if (depth != 0) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  return target;
}

bool complete(unsigned target) {
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

base::Error too_large(int width, int height, int most) {
  return {
      "the graphics driver cannot draw a picture of " + std::to_string(width) + " x " + std::to_string(height) + " px",
      "size", "use at most " + std::to_string(most) + " px a side"};
}

}  // namespace

Framebuffers::~Framebuffers() { release(); }

void Framebuffers::release() {
  for (const unsigned target :
       {surface_target_, picture_target_, picture_plain_target_, occlusion_target_, average_target_}) {
    if (target != 0) glDeleteFramebuffers(1, &target);
  }
  for (const unsigned buffer : {surface_color_, surface_depth_, plain_depth_}) {
    if (buffer != 0) glDeleteRenderbuffers(1, &buffer);
  }
  for (const unsigned texture : {picture_color_, depth_texture_, occlusion_texture_, average_texture_}) {
    if (texture != 0) glDeleteTextures(1, &texture);
  }
  surface_target_ = picture_target_ = picture_plain_target_ = occlusion_target_ = average_target_ = 0;
  surface_color_ = surface_depth_ = plain_depth_ = picture_color_ = depth_texture_ = occlusion_texture_ =
      average_texture_ = 0;
  width_ = height_ = 0;
}

base::Status Framebuffers::resize(int width, int height) {
  if (width == width_ && height == height_) return base::Done{};
  int most = 0;
  int most_texture = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most_texture);
  most = std::min(most, most_texture);
  if (width < 1 || height < 1 || width > most || height > most) return too_large(width, height, most);
  release();
  while (glGetError() != GL_NO_ERROR) {
  }
  samples_ = 1;
  if (dialect_.modern) glGetIntegerv(GL_MAX_SAMPLES, &samples_);
  samples_ = std::clamp(samples_, 1, most_samples_);
  if (samples_ == 1) samples_ = 0;  // one sample a px needs no target of its own
  if (samples_ > 0) {
    surface_color_ = make_renderbuffer(GL_RGBA8, samples_, width, height);
    surface_depth_ = make_renderbuffer(GL_DEPTH_COMPONENT24, samples_, width, height);
    glGenFramebuffers(1, &surface_target_);
    glBindFramebuffer(GL_FRAMEBUFFER, surface_target_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, surface_color_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, surface_depth_);
  }
  picture_color_ = make_texture(GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
  if (dialect_.modern) {
    depth_texture_ = make_texture(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, width, height);
    picture_target_ = make_target(picture_color_, depth_texture_);
  } else {
    picture_target_ = make_target(picture_color_, 0);
    glGenRenderbuffers(1, &plain_depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, plain_depth_);
    glRenderbufferStorage(GL_RENDERBUFFER, dialect_.depth_24 ? GL_DEPTH_COMPONENT24 : GL_DEPTH_COMPONENT16, width,
                          height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, plain_depth_);
  }
  picture_plain_target_ = make_target(picture_color_, 0);
  const bool good = (surface_target_ == 0 || complete(surface_target_)) && complete(picture_target_) &&
                    complete(picture_plain_target_) && glGetError() == GL_NO_ERROR;
  if (!good) {
    release();
    return too_large(width, height, std::min(most, 2048));
  }
  width_ = width;
  height_ = height;
  return base::Done{};
}

void Framebuffers::begin_surfaces() const {
  glBindFramebuffer(GL_FRAMEBUFFER, surface_target_ != 0 ? surface_target_ : picture_target_);
  glViewport(0, 0, width_, height_);
}

void Framebuffers::resolve() const {
  if (surface_target_ == 0) return begin_picture();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, surface_target_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture_target_);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                    GL_NEAREST);
  begin_picture();
}

void Framebuffers::begin_occlusion() {
  // Made when it is first asked for: a software renderer does without it.
  if (occlusion_target_ == 0) {
    occlusion_texture_ = make_texture(GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, width_, height_);
    occlusion_target_ = make_target(occlusion_texture_, 0);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, occlusion_target_);
}

void Framebuffers::begin_average(float share) {
  if (average_target_ == 0) {
    average_texture_ = make_texture(GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, width_, height_);
    average_target_ = make_target(average_texture_, 0);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, average_target_);
  glViewport(0, 0, width_, height_);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendColor(0, 0, 0, share);
  glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
}

void Framebuffers::blit_average() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, average_target_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture_target_);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  begin_picture();
}

void Framebuffers::begin_picture() const {
  glBindFramebuffer(GL_FRAMEBUFFER, picture_target_);
  glViewport(0, 0, width_, height_);
}
void Framebuffers::begin_picture_without_depth() const { glBindFramebuffer(GL_FRAMEBUFFER, picture_plain_target_); }

Image Framebuffers::read() const {
  Image image{width_, height_, {}};
  const auto row = static_cast<std::size_t>(width_) * 4;
  image.pixels.resize(row * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_FRAMEBUFFER, picture_target_);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  for (int y = 0; y < height_ / 2; ++y) {
    const auto upper = image.pixels.begin() + static_cast<std::ptrdiff_t>(row) * y;
    const auto lower = image.pixels.begin() + static_cast<std::ptrdiff_t>(row) * (height_ - 1 - y);
    std::swap_ranges(upper, upper + static_cast<std::ptrdiff_t>(row), lower);
  }
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
  return image;
}

void Framebuffers::begin_other(unsigned framebuffer, int x, int y) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(x, y, width_, height_);
  glDisable(GL_DEPTH_TEST);
}

void Framebuffers::blit_to(unsigned framebuffer, int x, int y) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_plain_target_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glBlitFramebuffer(0, 0, width_, height_, x, y, x + width_, y + height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

}  // namespace penpose::render
