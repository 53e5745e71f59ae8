#include "ui/render/gl/ground_pass.h"

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/render/gl/shaders.h"
#include "ui/render/light/baked_light.h"
#include "ui/render/light/ground_view.h"

namespace penpose::render {
namespace {

/// After k_screen_vertex. Rays of the camera meet the ground; coordinates are those of View.
constexpr std::string_view k_ground_fragment = R"(
from_vertex vec2 place;
uniform sampler2D picture;
uniform mat4 to_view;
uniform vec3 eye;          // from the middle of the square, in its half sides
uniform vec2 image_plane;
uniform float opacity;
void main() {
  vec3 d = vec3((place * 2.0 - 1.0) * image_plane, -1.0) * mat3(to_view);
  if (d.y >= -0.0001) discard;
  vec2 at = eye.xz - d.xz * (eye.y / d.y);
  if (max(abs(at.x), abs(at.y)) >= 1.0) discard;
  result = vec4(0.0, 0.0, 0.0, opacity * sample_picture(picture, at * 0.5 + 0.5).r);
}
)";

}  // namespace

base::Result<GroundPass> GroundPass::make(const GlDialect& dialect) {
  auto program = GlProgram::make(dialect, k_screen_vertex, k_ground_fragment, {"corner"});
  if (!program) return program.error();
  GroundPass pass;
  pass.program_ = std::move(*program);
  return pass;
}

GroundPass::~GroundPass() {
  if (texture_ != 0) glDeleteTextures(1, &texture_);
}

GroundPass::GroundPass(GroundPass&& other) noexcept
    : program_(std::move(other.program_)), texture_(std::exchange(other.texture_, 0)), sent_(std::move(other.sent_)) {}

GroundPass& GroundPass::operator=(GroundPass&& other) noexcept {
  std::swap(program_, other.program_);
  std::swap(texture_, other.texture_);
  std::swap(sent_, other.sent_);
  return *this;
}

bool GroundPass::begin(const std::shared_ptr<const BakedLight>& light, const View& view, geometry::Viewport viewport) {
  const auto seen = light ? view_of_ground(*light, view, viewport) : std::nullopt;
  if (!seen) return false;
  glActiveTexture(GL_TEXTURE0);
  if (texture_ == 0) glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  if (sent_ != light) {
    sent_ = light;
    std::vector<std::uint8_t> px;
    px.reserve(sent_->ground_shade.size() * 4);
    for (const std::uint8_t shade : sent_->ground_shade) px.insert(px.end(), {shade, shade, shade, 255});
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, BakedLight::k_ground_px, BakedLight::k_ground_px, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, px.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  program_.use();
  program_.set("picture", 0);
  program_.set_matrix("to_view", glm::value_ptr(view.to_view));
  program_.set("eye", seen->eye.x, seen->eye.y, seen->eye.z);
  program_.set("image_plane", view.image_plane.x, view.image_plane.y);
  program_.set("opacity", k_ground_opacity);
  glEnable(GL_SCISSOR_TEST);
  glScissor(seen->left, viewport.height - seen->bottom, seen->right - seen->left, seen->bottom - seen->top);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  return true;
}

void GroundPass::end() {
  glBindTexture(GL_TEXTURE_2D, 0);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
}

}  // namespace penpose::render
