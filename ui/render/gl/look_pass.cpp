#include "ui/render/gl/look_pass.h"

#include <algorithm>
#include <array>
#include <epoxy/gl.h>
#include <utility>

#include "ui/render/gl/shaders.h"
#include "ui/render/gl/vertex_data.h"
#include "ui/render/gl/view_uniforms.h"

namespace penpose::render {
namespace {

constexpr unsigned k_coordinates_place = 5;
constexpr unsigned k_tint_place = 6;

}  // namespace

base::Result<LookPass> LookPass::make() {
  auto program =
      GlProgram::make(std::string(k_place_functions).append(k_look_vertex), k_look_fragment,
                      {"position", "normal", "base_color", "finish", "overlay", "coordinates", "tint"}, k_lights);
  if (!program) return program.error();
  LookPass made;
  made.program_ = std::move(*program);
  for (unsigned* buffer : {&made.coordinates_, &made.tint_}) glGenBuffers(1, buffer);
  return made;
}

LookPass::LookPass(LookPass&& other) noexcept { *this = std::move(other); }
LookPass& LookPass::operator=(LookPass&& other) noexcept {
  std::swap(program_, other.program_);
  std::swap(textures_, other.textures_);
  std::swap(look_, other.look_);
  std::swap(coordinates_, other.coordinates_);
  std::swap(tint_, other.tint_);
  return *this;
}

LookPass::~LookPass() {
  for (const unsigned buffer : {coordinates_, tint_}) {
    if (buffer != 0) glDeleteBuffers(1, &buffer);
  }
}

void LookPass::upload(const Scene& scene, const DrawList& list) {
  const std::size_t vertex_count = scene.positions.size();
  look_ = list.batches.empty() ? nullptr : scene.appearance->look;
  if (!look_) {
    // Models without pictures take no memory for them; clay keeps them, because one looks at both in turn.
    if (scene.appearance == nullptr || !scene.appearance->look) textures_.clear();
    glDisableVertexAttribArray(k_coordinates_place);
    glDisableVertexAttribArray(k_tint_place);
    fill(GL_ARRAY_BUFFER, coordinates_, std::vector<float>(), GL_STATIC_DRAW);
    fill(GL_ARRAY_BUFFER, tint_, std::vector<float>(), GL_STATIC_DRAW);
    return;
  }
  const auto& [first, second] = look_->coordinates;
  std::vector<std::array<float, 4>> coordinates(vertex_count, std::array<float, 4>{0, 0, 0, 0});
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (!first.empty()) std::copy(first[v].begin(), first[v].end(), coordinates[v].begin());
    if (!second.empty()) std::copy(second[v].begin(), second[v].end(), coordinates[v].begin() + 2);
  }
  fill(GL_ARRAY_BUFFER, coordinates_, coordinates, GL_STATIC_DRAW);
  glEnableVertexAttribArray(k_coordinates_place);
  glVertexAttribPointer(k_coordinates_place, 4, GL_FLOAT, GL_FALSE, 16, offset(0));
  fill(GL_ARRAY_BUFFER, tint_, vertex_tint(*look_, vertex_count), GL_STATIC_DRAW);
  glEnableVertexAttribArray(k_tint_place);
  glVertexAttribPointer(k_tint_place, 4, GL_UNSIGNED_BYTE, GL_TRUE, 4, offset(0));
  textures_.keep(*look_, scene.appearance->batches);
}

void LookPass::draw_opaque(const View& view, const DrawList& list, std::span<const std::size_t> first_index) const {
  if (!look_) return;
  use_with_view(program_, view);
  for (const document::AlphaMode mode :
       {document::AlphaMode::opaque, document::AlphaMode::mask, document::AlphaMode::blend}) {
    for (std::size_t b = 0; b < list.batches.size(); ++b) {
      const LookBatch& batch = list.batches[b].of;
      if (look_->surfaces[batch.surface].alpha != mode) continue;
      draw_batch(batch, first_index[b], least_alpha(look_->surfaces[batch.surface]));
    }
  }
  glDisable(GL_CULL_FACE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void LookPass::draw_blended(const View& view, const DrawList& list, std::span<const std::size_t> first_index) const {
  if (list.blended.empty()) return;
  use_with_view(program_, view);
  for (const std::size_t b : list.blended) draw_batch(list.batches[b].of, first_index[b], k_nearly_clear);
  glDisable(GL_CULL_FACE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void LookPass::draw_batch(const LookBatch& batch, std::size_t first_index, float least_alpha) const {
  const document::Surface& surface = look_->surfaces[batch.surface];
  const auto single = [](double value) { return static_cast<float>(value); };
  const auto& color = surface.base_color;
  const bool textured = surface.texture && textures_.bind(*look_, *surface.texture);
  if (textured) {
    const TextureTransform place = transform_of(*surface.texture);
    program_.set("along_u", place.along_u.x, place.along_u.y);
    program_.set("along_v", place.along_v.x, place.along_v.y);
    program_.set("shift", place.shift.x, place.shift.y);
    program_.set("second_set", surface.texture->coordinates == 1 ? 1.0F : 0.0F);
  }
  const bool lost = surface.texture && !textured;  // its picture cannot be read: grey
  const double share = lost ? 0.6 : 1.0;
  program_.set("picture", 0);
  program_.set("textured", textured ? 1.0F : 0.0F);
  program_.set("factor", single(color[0] * share), single(color[1] * share), single(color[2] * share));
  program_.set("opacity", lost ? 1.0F : single(color[3]));
  program_.set("least_alpha", least_alpha);
  program_.set("unlit", surface.unlit && !lost ? 1.0F : 0.0F);
  program_.set("roughness", batch.roughness);
  program_.set("metallic", batch.metallic);
  if (surface.double_sided) {
    glDisable(GL_CULL_FACE);
  } else {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
  }
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.count * 3), GL_UNSIGNED_INT,
                 offset(first_index * sizeof(std::uint32_t)));
}

}  // namespace penpose::render
