#include "ui/render/gl/mesh_pass.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <string>
#include <utility>

#include "ui/render/gl/shaders.h"
#include "ui/render/gl/vertex_data.h"
#include "ui/render/gl/view_uniforms.h"

namespace penpose::render {
base::Result<MeshPass> MeshPass::make() {
  const auto attributes = {"position", "normal", "base_color", "finish", "overlay"};
  const std::string vertex = std::string(k_place_functions).append(k_mesh_vertex);
  auto surface = GlProgram::make(vertex, k_mesh_fragment, attributes, k_lights);
  if (!surface) return surface.error();
  auto wire = GlProgram::make(vertex, k_wire_fragment, attributes);
  if (!wire) return wire.error();
  auto looks = LookPass::make();
  if (!looks) return looks.error();
  MeshPass made;
  made.looks_ = std::move(*looks);
  made.surface_ = std::move(*surface);
  made.wire_ = std::move(*wire);
  glGenVertexArrays(1, &made.vertex_array_);
  for (unsigned* buffer : {&made.positions_, &made.normals_, &made.finish_, &made.overlay_, &made.indices_}) {
    glGenBuffers(1, buffer);
  }
  glBindVertexArray(made.vertex_array_);
  const auto attribute = [](unsigned place, unsigned buffer, int size, unsigned type, bool normalized, int stride,
                            std::size_t start) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, size, type, normalized ? GL_TRUE : GL_FALSE, stride, offset(start));
  };
  attribute(0, made.positions_, 3, GL_FLOAT, false, 12, 0);
  attribute(1, made.normals_, 3, GL_FLOAT, false, 12, 0);
  attribute(2, made.finish_, 4, GL_UNSIGNED_BYTE, true, 8, 0);
  attribute(3, made.finish_, 4, GL_UNSIGNED_BYTE, true, 8, 4);
  attribute(4, made.overlay_, 4, GL_UNSIGNED_BYTE, true, 4, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, made.indices_);
  glBindVertexArray(0);
  return made;
}

MeshPass::MeshPass(MeshPass&& other) noexcept
    : surface_(std::move(other.surface_)),
      wire_(std::move(other.wire_)),
      looks_(std::move(other.looks_)),
      tracker_(other.tracker_),
      list_(std::move(other.list_)),
      first_index_(std::move(other.first_index_)),
      vertex_array_(std::exchange(other.vertex_array_, 0)),
      positions_(std::exchange(other.positions_, 0)),
      normals_(std::exchange(other.normals_, 0)),
      finish_(std::exchange(other.finish_, 0)),
      overlay_(std::exchange(other.overlay_, 0)),
      indices_(std::exchange(other.indices_, 0)),
      opaque_count_(other.opaque_count_),
      translucent_count_(other.translucent_count_),
      edge_count_(other.edge_count_),
      first_edge_(other.first_edge_) {}

MeshPass::~MeshPass() {
  if (vertex_array_ != 0) glDeleteVertexArrays(1, &vertex_array_);
  for (const unsigned buffer : {positions_, normals_, finish_, overlay_, indices_}) {
    if (buffer != 0) glDeleteBuffers(1, &buffer);
  }
}

void MeshPass::order(const Scene& scene, const View& view) {
  if (list_.blended.empty()) return;
  glBindVertexArray(vertex_array_);
  order_blended(list_, scene, view, [&](std::size_t b) {
    const auto& triangles = list_.batches[b].triangles;
    glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(first_index_[b] * sizeof(std::uint32_t)),
                    static_cast<GLsizeiptr>(triangles.size() * sizeof(mesh::Triangle)), triangles.data());
  });
  glBindVertexArray(0);
}

void MeshPass::upload_shape(const Scene& scene) {
  list_ = make_draw_list(scene);
  fill(GL_ARRAY_BUFFER, finish_, vertex_finish(scene), GL_STATIC_DRAW);
  // Opaque triangles, then translucent ones, then those of the look, then the edges.
  std::vector<std::uint32_t> indices;
  indices.reserve(scene.triangles.size() * 3 + list_.edges.size() * 2);
  const auto add = [&](const std::vector<mesh::Triangle>& triangles) {
    for (const mesh::Triangle& t : triangles) indices.insert(indices.end(), t.begin(), t.end());
    return static_cast<int>(triangles.size() * 3);
  };
  opaque_count_ = add(list_.opaque);
  translucent_count_ = add(list_.translucent);
  first_index_.clear();
  for (const DrawList::Batch& batch : list_.batches) {
    first_index_.push_back(indices.size());
    add(batch.triangles);
  }
  first_edge_ = indices.size();
  edge_count_ = static_cast<int>(list_.edges.size() * 2);
  for (const auto& [a, b] : list_.edges) indices.insert(indices.end(), {a, b});
  glBindVertexArray(vertex_array_);
  fill(GL_ELEMENT_ARRAY_BUFFER, indices_, indices, GL_STATIC_DRAW);
  looks_.upload(scene, list_);
  glBindVertexArray(0);
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
  if (changes->pose) {
    fill(positions_, scene.positions);
    fill(normals_, scene.normals);
  }
  if (changes->overlay) {
    std::vector<Bytes4> colors(scene.positions.size(), Bytes4{0, 0, 0, 0});
    std::transform(scene.overlay.begin(), scene.overlay.end(), colors.begin(), pack);
    fill(GL_ARRAY_BUFFER, overlay_, colors, GL_DYNAMIC_DRAW);
  }
  return base::Done{};
}

void MeshPass::draw_opaque(const View& view, bool wireframe) const {
  glBindVertexArray(vertex_array_);
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
  glDrawElements(GL_TRIANGLES, opaque_count_, GL_UNSIGNED_INT, nullptr);
  looks_.draw_opaque(view, list_, first_index_);
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (wireframe && edge_count_ > 0) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    use_with_view(wire_, view);
    glDrawElements(GL_LINES, edge_count_, GL_UNSIGNED_INT, offset(first_edge_ * sizeof(std::uint32_t)));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
  }
  glBindVertexArray(0);
}

void MeshPass::draw_translucent(const View& view) const {
  if (translucent_count_ == 0 && list_.blended.empty()) return;
  glBindVertexArray(vertex_array_);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  looks_.draw_blended(view, list_, first_index_);
  if (translucent_count_ > 0) {
    use_with_view(surface_, view);
    surface_.set("opaque_pass", 0.0F);
    glDrawElements(GL_TRIANGLES, translucent_count_, GL_UNSIGNED_INT,
                   offset(static_cast<std::size_t>(opaque_count_) * sizeof(std::uint32_t)));
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
}

}  // namespace penpose::render
