#include "ui/render/gl/behind_pass.h"

#include <epoxy/gl.h>
#include <utility>

#include "ui/render/gl/shaders.h"

namespace penpose::render {
namespace {

constexpr std::string_view k_behind_fragment = R"(
in vec2 place;
uniform sampler2D picture;
uniform vec2 from;
uniform vec2 to;
uniform float opacity;
out vec4 result;
void main() {
  vec2 at = (place - from) / (to - from);
  if (at.x < 0.0 || at.y < 0.0 || at.x > 1.0 || at.y > 1.0) discard;
  vec4 color = texture(picture, at);
  result = vec4(color.rgb, color.a * opacity);
}
)";

}  // namespace

base::Result<BehindPass> BehindPass::make() {
  auto program = GlProgram::make(k_screen_vertex, k_behind_fragment, {});
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
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, sent_->width, sent_->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
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
