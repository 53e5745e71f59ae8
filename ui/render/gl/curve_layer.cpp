#include "ui/render/gl/curve_layer.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <string_view>
#include <utility>

#include "ui/render/cpu/curve_ink.h"

namespace penpose::render {
namespace {

constexpr std::string_view k_layer_vertex = R"(
from_buffer vec2 corner;
uniform vec2 share;
to_fragment vec2 at;
void main() {
  at = vec2(corner.x * 0.5 + 0.5, 0.5 - corner.y * 0.5) * share;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

constexpr std::string_view k_layer_fragment = R"(
from_vertex vec2 at;
uniform sampler2D picture;
void main() {
  result = sample_picture(picture, at);
}
)";

/// Textures grow in such steps, px, so that a line that grows does not make one each time.
constexpr int k_step = 128;
int whole_steps(int px) { return (px + k_step - 1) / k_step * k_step; }

}  // namespace

base::Result<CurveLayer> CurveLayer::make(const GlDialect& dialect) {
  auto program = GlProgram::make(dialect, k_layer_vertex, k_layer_fragment, {"corner"});
  if (!program) return program.error();
  return CurveLayer(std::move(*program));
}

CurveLayer::~CurveLayer() {
  if (texture_ != 0) glDeleteTextures(1, &texture_);
}

CurveLayer::CurveLayer(CurveLayer&& other) noexcept
    : program_(std::move(other.program_)),
      texture_(std::exchange(other.texture_, 0)),
      texture_width_(other.texture_width_),
      texture_height_(other.texture_height_),
      ink_(std::move(other.ink_)),
      sent_(std::move(other.sent_)) {}

void CurveLayer::send(const PxRect& part) {
  const int width = part.right - part.left;
  const int height = part.bottom - part.top;
  if (texture_ == 0) glGenTextures(1, &texture_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  if (width > texture_width_ || height > texture_height_) {
    texture_width_ = std::max(texture_width_, std::min(whole_steps(width), ink_.width));
    texture_height_ = std::max(texture_height_, std::min(whole_steps(height), ink_.height));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, texture_width_, texture_height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  // Sent without what lies beside it, and left clear for the next picture.
  const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(width) * 4;
  sent_.clear();
  sent_.reserve(static_cast<std::size_t>(row * height));
  for (int y = part.top; y < part.bottom; ++y) {
    const auto from = ink_.pixels.begin() + (static_cast<std::ptrdiff_t>(y) * ink_.width + part.left) * 4;
    sent_.insert(sent_.end(), from, from + row);
    std::fill(from, from + row, std::uint8_t{0});
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, sent_.data());
}

void CurveLayer::draw(std::span<const CurveDrawing> curves, const geometry::Camera& camera, const ScreenFill& screen) {
  const auto [width, height] = camera.viewport();
  if (curves.empty()) return;
  if (ink_.width != width || ink_.height != height) {
    ink_ = {width, height,
            std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 0)};
  }
  const PxRect part = draw_curves(curves, camera, ink_);
  if (part.empty()) return;
  send(part);
  program_.use();
  program_.set("picture", 0);
  program_.set("share", static_cast<float>(part.right - part.left) / static_cast<float>(texture_width_),
               static_cast<float>(part.bottom - part.top) / static_cast<float>(texture_height_));
  glViewport(part.left, height - part.bottom, part.right - part.left, part.bottom - part.top);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  screen.draw();
  glDisable(GL_BLEND);
  glViewport(0, 0, width, height);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace penpose::render
