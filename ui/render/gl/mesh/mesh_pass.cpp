#include "ui/render/gl/mesh/mesh_pass.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <string>
#include <utility>

#include "ui/render/gl/mesh/view_uniforms.h"
#include "ui/render/gl/shaders.h"

namespace penpose::render {

base::Result<MeshPass> MeshPass::make(const GlDialect& dialect) {
  const auto attributes = {"position", "normal", "base_color", "finish", "overlay", "coordinates", "tint", "light"};
  const std::string vertex = std::string(k_place_functions).append(k_mesh_vertex);
  auto surface = GlProgram::make(dialect, vertex, k_mesh_fragment, attributes, k_lights);
  if (!surface) return surface.error();
  auto wire = GlProgram::make(dialect, vertex, k_wire_fragment, attributes);
  if (!wire) return wire.error();
  auto looks = LookPass::make(dialect);
  if (!looks) return looks.error();
  return MeshPass(dialect, std::move(*surface), std::move(*wire), std::move(*looks));
}

MeshPass::MeshPass(const GlDialect& dialect, GlProgram surface, GlProgram wire, LookPass looks)
    : surface_(std::move(surface)), wire_(std::move(wire)), looks_(std::move(looks)), buffers_(dialect) {
  for (unsigned* buffer : {&positions_, &normals_, &finish_, &overlay_, &light_}) *buffer = buffers_.add_buffer();
  buffers_.set({0, positions_, 3, GL_FLOAT, 12, 0});
  buffers_.set({1, normals_, 3, GL_FLOAT, 12, 0});
  buffers_.set({2, finish_, 4, GL_UNSIGNED_BYTE, 8, 0});
  buffers_.set({3, finish_, 4, GL_UNSIGNED_BYTE, 8, 4});
  buffers_.set({4, overlay_, 4, GL_UNSIGNED_BYTE, 4, 0});
  buffers_.set({7, light_, 4, GL_UNSIGNED_BYTE, 4, 0});
  looks_.add_to(buffers_);
  buffers_.unbind();
}

void MeshPass::order(const Scene& scene, const View& view) {
  bool again = false;
  order_blended(list_, scene, view,
                [&](std::size_t b) { again = buffers_.replace(first_index_[b], list_.batches[b].triangles) || again; });
  if (!again) return;
  buffers_.split_again();
  upload_finish(scene);
  upload_pose(scene);
  upload_overlay(scene);
  looks_.upload_vertices(scene, buffers_);
}

void MeshPass::upload_shape(const Scene& scene) {
  list_ = make_draw_list(scene);
  toon_ = render::has_toon(list_, scene.appearance);
  // Opaque triangles, then translucent ones, then those of the look, then the edges.
  std::vector<std::uint32_t> indices;
  indices.reserve(scene.triangles.size() * 3 + list_.edges.size() * 2);
  const auto add = [&](const std::vector<mesh::Triangle>& triangles) {
    for (const mesh::Triangle& t : triangles) indices.insert(indices.end(), t.begin(), t.end());
    return triangles.size() * 3;
  };
  opaque_count_ = add(list_.opaque);
  translucent_count_ = add(list_.translucent);
  first_index_.clear();
  for (const DrawList::Batch& batch : list_.batches) {
    first_index_.push_back(indices.size());
    add(batch.triangles);
  }
  first_edge_ = indices.size();
  edge_count_ = list_.edges.size() * 2;
  for (const auto& [a, b] : list_.edges) indices.insert(indices.end(), {a, b});
  buffers_.send_indices(std::move(indices), first_edge_, scene.positions.size());
  upload_finish(scene);
  looks_.upload(scene, list_, buffers_);
  // The card has what is not sorted.
  list_.opaque = {};
  list_.translucent = {};
  list_.edges = {};
  for (std::size_t b = 0; b < list_.batches.size(); ++b) {
    if (std::find(list_.blended.begin(), list_.blended.end(), b) == list_.blended.end())
      list_.batches[b].triangles = {};
  }
}

base::Status MeshPass::upload(const Scene& scene) {
  const auto changes = tracker_.look_at(scene);
  if (!changes) return changes.error();
  if (changes->shape) upload_shape(scene);
  if (changes->pose) upload_pose(scene);
  if (changes->overlay) upload_overlay(scene);
  return base::Done{};
}

void MeshPass::upload_finish(const Scene& scene) {
  matcap_ = scene.matcap;
  buffers_.send(finish_, std::span<const VertexFinish>(vertex_finish(scene)), GL_STATIC_DRAW);
  buffers_.send(light_, std::span<const Bytes4>(vertex_light(scene)), GL_STATIC_DRAW);
}

void MeshPass::upload_pose(const Scene& scene) {
  buffers_.send(positions_, scene.positions, GL_STREAM_DRAW);
  buffers_.send(normals_, scene.normals, GL_STREAM_DRAW);
}

void MeshPass::upload_overlay(const Scene& scene) {
  std::vector<Bytes4> colors(scene.positions.size(), Bytes4{0, 0, 0, 0});
  std::transform(scene.overlay.begin(), scene.overlay.end(), colors.begin(), pack);
  buffers_.send(overlay_, std::span<const Bytes4>(colors), GL_DYNAMIC_DRAW);
}

void MeshPass::draw_opaque(const View& view, bool wireframe) const {
  buffers_.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  if (wireframe) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0F, 2.0F);
  }
  use_with_view(surface_, view);
  surface_.set("opaque_pass", 1.0F);
  surface_.set("matcap", matcap_ ? 1.0F : 0.0F);
  buffers_.draw(GL_TRIANGLES, 0, opaque_count_);
  looks_.draw_opaque(view, list_, first_index_, buffers_);
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (wireframe && edge_count_ > 0) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    use_with_view(wire_, view);
    buffers_.draw(GL_LINES, first_edge_, edge_count_);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
  }
  buffers_.unbind();
}

void MeshPass::draw_translucent(const View& view) const {
  if (translucent_count_ == 0 && list_.blended.empty()) return;
  buffers_.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  looks_.draw_blended(view, list_, first_index_, buffers_);
  if (translucent_count_ > 0) {
    use_with_view(surface_, view);
    surface_.set("opaque_pass", 0.0F);
    surface_.set("matcap", matcap_ ? 1.0F : 0.0F);
    buffers_.draw(GL_TRIANGLES, opaque_count_, translucent_count_);
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  buffers_.unbind();
}

}  // namespace penpose::render
