#include "ui/render/gl/behind_pass.h"

#include <epoxy/gl.h>
#include <string_view>
#include <utility>

namespace penpose::render {
namespace {

constexpr std::string_view k_behind_vertex = R"(
from_buffer vec2 corner;
uniform vec2 from;
uniform vec2 to;
to_fragment vec2 at;
void main() {
  at = (corner * 0.5 + 0.5 - from) / (to - from);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

constexpr std::string_view k_behind_fragment = R"(
from_vertex vec2 at;
uniform sampler2D picture;
uniform float opacity;
void main() {
  if (at.x < 0.0 || at.y < 0.0 || at.x > 1.0 || at.y > 1.0) discard;
  vec4 color = sample_picture(picture, at);
  result = vec4(color.rgb, color.a * opacity);
}
)";

}  // namespace

base::Result<BehindPass> BehindPass::make(const GlDialect& dialect) {
  auto program = GlProgram::make(dialect, k_behind_vertex, k_behind_fragment, {"corner"});
  if (!program) return program.error();
  BehindPass pass;
  pass.program_ = std::move(*program);
  return pass;
}

BehindPass::~BehindPass() {
  if (texture_ != 0) glDeleteTextures(1, &texture_);
}

BehindPass::BehindPass(BehindPass&& other) noexcept
    : program_(std::move(other.program_)), texture_(std::exchange(other.texture_, 0)), sent_(std::move(other.sent_)) {}

BehindPass& BehindPass::operator=(BehindPass&& other) noexcept {
  std::swap(program_, other.program_);
  std::swap(texture_, other.texture_);
  std::swap(sent_, other.sent_);
  return *this;
}

bool BehindPass::begin(const Behind& behind, geometry::Viewport viewport) {
  if (!behind.image || behind.from.x == behind.to.x || behind.from.y == behind.to.y) {
    // A picture that is gone takes no memory.
    if (texture_ != 0 && !behind.image) glDeleteTextures(1, &texture_);
    if (!behind.image) texture_ = 0;
    if (!behind.image) sent_.reset();
    return false;
  }
  glActiveTexture(GL_TEXTURE0);
  if (texture_ == 0) glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  if (sent_ != behind.image) {
    sent_ = behind.image;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, sent_->width, sent_->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 sent_->pixels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  // Places on the screen count from its foot, rows of the picture from its top.
  const auto across = [&](double x) { return static_cast<float>(x / viewport.width); };
  const auto upright = [&](double y) { return static_cast<float>(1 - y / viewport.height); };
  program_.use();
  program_.set("picture", 0);
  program_.set("from", across(behind.from.x), upright(behind.from.y));
  program_.set("to", across(behind.to.x), upright(behind.to.y));
  program_.set("opacity", behind.opacity);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  return true;
}

void BehindPass::end() {
  glBindTexture(GL_TEXTURE_2D, 0);
  glDisable(GL_BLEND);
}

}  // namespace penpose::render
