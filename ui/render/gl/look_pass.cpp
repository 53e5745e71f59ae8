#include "ui/render/gl/look_pass.h"

#include <algorithm>
#include <array>
#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <utility>

#include "core/base/math.h"
#include "ui/render/gl/shaders.h"
#include "ui/render/gl/vertex_data.h"

namespace penpose::render {
namespace {

constexpr unsigned k_coordinates_place = 5;
constexpr unsigned k_tint_place = 6;
/// Of what is blended, all that is as good as opaque hides what is behind it.
constexpr float k_nearly_opaque = 0.98F;
constexpr float k_nearly_clear = 0.004F;

}  // namespace

bool LookPass::fits(const Appearance& appearance, std::size_t vertices, std::size_t triangles) {
  if (!appearance.look) return appearance.batches.empty();
  const document::Look& look = *appearance.look;
  const auto fits = [&](std::size_t size) { return size == 0 || size == vertices; };
  const auto batch_fits = [&](const LookBatch& batch) {
    return batch.surface < look.surfaces.size() && batch.first <= appearance.look_triangles.size() &&
           batch.count <= appearance.look_triangles.size() - batch.first;
  };
  return fits(look.coordinates[0].size()) && fits(look.coordinates[1].size()) && fits(look.colors.size()) &&
         std::all_of(appearance.batches.begin(), appearance.batches.end(), batch_fits) &&
         std::all_of(appearance.look_triangles.begin(), appearance.look_triangles.end(),
                     [&](std::uint32_t t) { return t < triangles; });
}

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
  std::swap(batches_, other.batches_);
  std::swap(blended_, other.blended_);
  std::swap(coordinates_, other.coordinates_);
  std::swap(tint_, other.tint_);
  return *this;
}

LookPass::~LookPass() {
  for (const unsigned buffer : {coordinates_, tint_}) {
    if (buffer != 0) glDeleteBuffers(1, &buffer);
  }
}

void LookPass::add_indices(const Appearance& appearance, bool shown, std::span<const mesh::Triangle> triangles,
                           std::vector<std::uint32_t>& indices) {
  batches_.clear();
  blended_.clear();
  if (!shown || !appearance.look) return;
  for (const LookBatch& one : appearance.batches) {
    Batch batch{one, indices.size(), {}};
    const bool blends = appearance.look->surfaces[one.surface].alpha == document::AlphaMode::blend;
    for (const std::uint32_t i : std::span(appearance.look_triangles).subspan(one.first, one.count)) {
      const mesh::Triangle& t = triangles[i];
      indices.insert(indices.end(), t.begin(), t.end());
      if (blends) batch.triangles.push_back(t);
    }
    if (blends) blended_.push_back(batches_.size());
    batches_.push_back(std::move(batch));
  }
}

void LookPass::upload(const Appearance& appearance, std::size_t vertex_count) {
  look_ = batches_.empty() ? nullptr : appearance.look;
  if (!look_) {
    // Models without pictures take no memory for them; clay keeps them, because one looks at both in turn.
    if (!appearance.look) textures_.clear();
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
  std::vector<Bytes4> tint(vertex_count, Bytes4{255, 255, 255, 255});
  for (std::size_t v = 0; v < look_->colors.size(); ++v) {
    const auto& c = look_->colors[v];
    tint[v] = pack({c[0], c[1], c[2], c[3]});
  }
  fill(GL_ARRAY_BUFFER, coordinates_, coordinates, GL_STATIC_DRAW);
  glEnableVertexAttribArray(k_coordinates_place);
  glVertexAttribPointer(k_coordinates_place, 4, GL_FLOAT, GL_FALSE, 16, offset(0));
  fill(GL_ARRAY_BUFFER, tint_, tint, GL_STATIC_DRAW);
  glEnableVertexAttribArray(k_tint_place);
  glVertexAttribPointer(k_tint_place, 4, GL_UNSIGNED_BYTE, GL_TRUE, 4, offset(0));
  textures_.keep(*look_, appearance.batches);
}

void LookPass::order(const Scene& scene, const View& view) {
  if (blended_.empty()) return;
  // Away from the eye is against z.
  const glm::vec3 away{-view.to_view[0][2], -view.to_view[1][2], -view.to_view[2][2]};
  std::vector<double> depth_of(batches_.size(), 0);
  std::vector<std::pair<float, mesh::Triangle>> sorted;
  for (const std::size_t b : blended_) {
    Batch& batch = batches_[b];
    sorted.clear();
    for (const mesh::Triangle& t : batch.triangles) {
      const float depth = glm::dot(away, scene.positions[t[0]] + scene.positions[t[1]] + scene.positions[t[2]]);
      depth_of[b] += static_cast<double>(depth) / static_cast<double>(batch.triangles.size());
      sorted.emplace_back(depth, t);
    }
    const auto farther = [](const auto& one, const auto& other) { return one.first > other.first; };
    if (!(std::is_sorted(sorted.begin(), sorted.end(), farther))) {
      std::stable_sort(sorted.begin(), sorted.end(), farther);
      std::transform(sorted.begin(), sorted.end(), batch.triangles.begin(), [](const auto& one) { return one.second; });
      glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(batch.first_index * sizeof(std::uint32_t)),
                      static_cast<GLsizeiptr>(batch.triangles.size() * sizeof(mesh::Triangle)), batch.triangles.data());
    }
  }
  std::sort(blended_.begin(), blended_.end());
  std::stable_sort(blended_.begin(), blended_.end(),
                   [&](std::size_t a, std::size_t b) { return depth_of[a] > depth_of[b]; });
}

void LookPass::draw_opaque(const View& view) const {
  if (!look_) return;
  use_with_view(program_, view);
  for (const document::AlphaMode mode :
       {document::AlphaMode::opaque, document::AlphaMode::mask, document::AlphaMode::blend}) {
    for (const Batch& batch : batches_) {
      const document::Surface& surface = look_->surfaces[batch.of.surface];
      if (surface.alpha != mode) continue;
      draw_batch(batch, mode == document::AlphaMode::opaque ? -1.0F
                        : mode == document::AlphaMode::mask ? static_cast<float>(surface.alpha_cutoff)
                                                            : k_nearly_opaque);
    }
  }
  glDisable(GL_CULL_FACE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void LookPass::draw_blended(const View& view) const {
  if (blended_.empty()) return;
  use_with_view(program_, view);
  for (const std::size_t b : blended_) draw_batch(batches_[b], k_nearly_clear);
  glDisable(GL_CULL_FACE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void LookPass::draw_batch(const Batch& batch, float least_alpha) const {
  const document::Surface& surface = look_->surfaces[batch.of.surface];
  const auto single = [](double value) { return static_cast<float>(value); };
  const auto& color = surface.base_color;
  const bool textured = surface.texture && textures_.bind(*look_, *surface.texture);
  if (textured) {
    // KHR_texture_transform: shift, turn, scale. Its turn counts against the clock where v runs down.
    const document::TextureUse& use = *surface.texture;
    const double sine = base::sin(use.rotation);
    const double cosine = base::cos(use.rotation);
    program_.set("along_u", single(cosine * use.scale[0]), single(-sine * use.scale[0]));
    program_.set("along_v", single(sine * use.scale[1]), single(cosine * use.scale[1]));
    program_.set("shift", single(use.offset[0]), single(use.offset[1]));
    program_.set("second_set", use.coordinates == 1 ? 1.0F : 0.0F);
  }
  const bool lost = surface.texture && !textured;  // its picture cannot be read: grey
  const double share = lost ? 0.6 : 1.0;
  program_.set("picture", 0);
  program_.set("textured", textured ? 1.0F : 0.0F);
  program_.set("factor", single(color[0] * share), single(color[1] * share), single(color[2] * share));
  program_.set("opacity", lost ? 1.0F : single(color[3]));
  program_.set("least_alpha", least_alpha);
  program_.set("unlit", surface.unlit && !lost ? 1.0F : 0.0F);
  program_.set("roughness", batch.of.roughness);
  program_.set("metallic", batch.of.metallic);
  if (surface.double_sided) {
    glDisable(GL_CULL_FACE);
  } else {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
  }
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.of.count * 3), GL_UNSIGNED_INT,
                 offset(batch.first_index * sizeof(std::uint32_t)));
}

}  // namespace penpose::render
