#include "ui/render/gl/mesh/look_pass.h"

#include <algorithm>
#include <array>
#include <epoxy/gl.h>
#include <utility>

#include "ui/render/gl/mesh/view_uniforms.h"
#include "ui/render/gl/shaders.h"

namespace penpose::render {
namespace {

constexpr unsigned k_coordinates_place = 5;
constexpr unsigned k_tint_place = 6;

}  // namespace

base::Result<LookPass> LookPass::make(const GlDialect& dialect) {
  auto program = GlProgram::make(
      dialect, std::string(k_place_functions).append(k_look_vertex), k_look_fragment,
      {"position", "normal", "base_color", "finish", "overlay", "coordinates", "tint", "light"}, k_lights);
  if (!program) return program.error();
  return LookPass(dialect, std::move(*program));
}

void LookPass::add_to(MeshBuffers& mesh) {
  coordinates_ = mesh.add_buffer();
  tint_ = mesh.add_buffer();
}

void LookPass::upload(const Scene& scene, const DrawList& list, MeshBuffers& mesh) {
  look_ = list.batches.empty() ? nullptr : scene.appearance->look;
  if (!look_) {
    // Models without pictures take no memory for them; clay keeps them, because one looks at both in turn.
    if (scene.appearance == nullptr || !scene.appearance->look) textures_.clear();
    mesh.drop(k_coordinates_place);
    mesh.drop(k_tint_place);
    mesh.send(coordinates_, std::span<const float>(), GL_STATIC_DRAW);
    mesh.send(tint_, std::span<const float>(), GL_STATIC_DRAW);
    mesh.unbind();
    return;
  }
  upload_vertices(scene, mesh);
  mesh.set({k_coordinates_place, coordinates_, 4, GL_FLOAT, 16, 0});
  mesh.set({k_tint_place, tint_, 4, GL_UNSIGNED_BYTE, 4, 0});
  mesh.unbind();
  textures_.keep(*look_, scene.appearance->batches);
}

void LookPass::upload_vertices(const Scene& scene, MeshBuffers& mesh) {
  if (!look_) return;
  const std::size_t vertex_count = scene.positions.size();
  const auto& [first, second] = look_->coordinates;
  std::vector<std::array<float, 4>> coordinates(vertex_count, std::array<float, 4>{0, 0, 0, 0});
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (!first.empty()) std::copy(first[v].begin(), first[v].end(), coordinates[v].begin());
    if (!second.empty()) std::copy(second[v].begin(), second[v].end(), coordinates[v].begin() + 2);
  }
  mesh.send(coordinates_, std::span<const std::array<float, 4>>(coordinates), GL_STATIC_DRAW);
  mesh.send(tint_, std::span<const Bytes4>(vertex_tint(*look_, vertex_count)), GL_STATIC_DRAW);
}

void LookPass::draw_opaque(const View& view, const DrawList& list, std::span<const std::size_t> first_index,
                           const MeshBuffers& mesh) const {
  if (!look_) return;
  use_with_view(program_, view);
  for (const document::AlphaMode mode :
       {document::AlphaMode::opaque, document::AlphaMode::mask, document::AlphaMode::blend}) {
    for (std::size_t b = 0; b < list.batches.size(); ++b) {
      const LookBatch& batch = list.batches[b].of;
      if (look_->surfaces[batch.surface].alpha != mode) continue;
      draw_batch(batch, first_index[b], least_alpha(look_->surfaces[batch.surface]), mesh);
    }
  }
  draw_outlines(view, list, first_index, mesh);
  glDisable(GL_CULL_FACE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void LookPass::draw_outlines(const View& view, const DrawList& list, std::span<const std::size_t> first_index,
                             const MeshBuffers& mesh) const {
  // Their backs, a little larger: what is seen of them is a line around the surface.
  for (std::size_t b = 0; b < list.batches.size(); ++b) {
    const LookBatch& batch = list.batches[b].of;
    const document::Surface& surface = look_->surfaces[batch.surface];
    if (!has_outline(surface)) continue;
    set_batch(batch, least_alpha(surface));
    const glm::vec2 reach = outline_reach(*surface.toon, view);
    program_.set("outline", reach.x, reach.y);
    const auto& color = surface.toon->outline_color;
    program_.set("outline_color", static_cast<float>(color[0]), static_cast<float>(color[1]),
                 static_cast<float>(color[2]));
    program_.set("outline_mix", static_cast<float>(surface.toon->outline_mix));
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    mesh.draw(GL_TRIANGLES, first_index[b], static_cast<std::size_t>(batch.count) * 3);
  }
  glCullFace(GL_BACK);
}

void LookPass::draw_blended(const View& view, const DrawList& list, std::span<const std::size_t> first_index,
                            const MeshBuffers& mesh) const {
  if (list.blended.empty()) return;
  use_with_view(program_, view);
  for (const std::size_t b : list.blended) draw_batch(list.batches[b].of, first_index[b], k_nearly_clear, mesh);
  glDisable(GL_CULL_FACE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void LookPass::draw_batch(const LookBatch& batch, std::size_t first_index, float least_alpha,
                          const MeshBuffers& mesh) const {
  set_batch(batch, least_alpha);
  program_.set("outline", 0.0F, 0.0F);
  program_.set("outline_mix", -1.0F);
  if (look_->surfaces[batch.surface].double_sided) {
    glDisable(GL_CULL_FACE);
  } else {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
  }
  mesh.draw(GL_TRIANGLES, first_index, static_cast<std::size_t>(batch.count) * 3);
}

/// Its tones, and pictures in units 1 and 2. Both samplers have a picture, whether it is looked at or not.
void LookPass::set_toon(const document::Surface& surface) const {
  program_.set("shade_picture", 1);
  program_.set("outline_picture", 2);
  program_.set("shade_textured", 0.0F);
  program_.set("outline_textured", 0.0F);
  if (!surface.toon) return program_.set("toon", 0.0F, 0.0F, 0.0F);
  const document::Toon& toon = *surface.toon;
  program_.set("toon", 1.0F, static_cast<float>(toon.shift), static_cast<float>(toon.toony));
  const auto& shade = toon.shade_color;
  program_.set("shade_factor", static_cast<float>(shade[0]), static_cast<float>(shade[1]),
               static_cast<float>(shade[2]));
  if (toon.shade_texture && textures_.bind(*look_, *toon.shade_texture, 1)) program_.set("shade_textured", 1.0F);
  const bool varies = toon.outline != document::OutlineWidth::none && toon.outline_texture;
  if (varies && textures_.bind(*look_, *toon.outline_texture, 2)) program_.set("outline_textured", 1.0F);
  glActiveTexture(GL_TEXTURE0);
}

void LookPass::set_batch(const LookBatch& batch, float least_alpha) const {
  const document::Surface& surface = look_->surfaces[batch.surface];
  set_toon(surface);
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
}

}  // namespace penpose::render
