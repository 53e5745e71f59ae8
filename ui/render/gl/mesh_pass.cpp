#include "ui/render/gl/mesh_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <epoxy/gl.h>
#include <string>
#include <utility>

#include "ui/render/gl/shaders.h"
#include "ui/render/gl/vertex_data.h"

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
      clay_(other.clay_),
      vertex_array_(std::exchange(other.vertex_array_, 0)),
      positions_(std::exchange(other.positions_, 0)),
      normals_(std::exchange(other.normals_, 0)),
      finish_(std::exchange(other.finish_, 0)),
      overlay_(std::exchange(other.overlay_, 0)),
      indices_(std::exchange(other.indices_, 0)),
      vertex_count_(other.vertex_count_),
      triangle_count_(other.triangle_count_),
      opaque_count_(other.opaque_count_),
      translucent_count_(other.translucent_count_),
      edge_count_(other.edge_count_),
      has_edges_(other.has_edges_),
      shape_number_(other.shape_number_),
      pose_number_(other.pose_number_),
      overlay_number_(other.overlay_number_),
      overlay_is_clear_(other.overlay_is_clear_) {}

MeshPass::~MeshPass() {
  if (vertex_array_ != 0) glDeleteVertexArrays(1, &vertex_array_);
  for (const unsigned buffer : {positions_, normals_, finish_, overlay_, indices_}) {
    if (buffer != 0) glDeleteBuffers(1, &buffer);
  }
}

void MeshPass::order(const Scene& scene, const View& view) {
  if (!looks_.blends()) return;
  glBindVertexArray(vertex_array_);
  looks_.order(scene, view);
  glBindVertexArray(0);
}

void MeshPass::upload_shape(const Scene& scene) {
  const Appearance plain{{Surface{}}, {}, {}, {}};
  const Appearance& look = scene.appearance != nullptr ? *scene.appearance : plain;
  const auto surface_of = [&](std::size_t v) -> const Surface& {
    return look.surfaces[look.surface_of_vertex.empty() ? 0 : look.surface_of_vertex[v]];
  };
  std::vector<std::array<Bytes4, 2>> finish(vertex_count_);
  for (std::size_t v = 0; v < vertex_count_; ++v) {
    const Surface& surface = surface_of(v);
    finish[v] = {pack(surface.base_color), Bytes4{to_byte(surface.roughness), to_byte(surface.metallic),
                                                  to_byte(look.gaze.empty() ? 1.0F : look.gaze[v]),
                                                  to_byte(look.opacity.empty() ? 1.0F : look.opacity[v])}};
  }
  fill(GL_ARRAY_BUFFER, finish_, finish, GL_STATIC_DRAW);
  // Opaque triangles, then translucent ones, then those of the look, then (when asked for) the edges of the opaque
  // ones.
  const bool looks = look.look && !scene.clay;
  std::vector<bool> is_of_look(looks ? scene.triangles.size() : 0, false);
  if (looks) {
    for (const std::uint32_t t : look.look_triangles) is_of_look[t] = true;
  }
  std::vector<std::uint32_t> indices;
  indices.reserve(scene.triangles.size() * (scene.wireframe ? 6 : 3));
  const auto clear = [&](const mesh::Triangle& t) { return surface_of(t[0]).base_color.a < 1.0F; };
  for (const bool wanted : {false, true}) {
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
      const mesh::Triangle& t = scene.triangles[i];
      if ((!looks || !is_of_look[i]) && clear(t) == wanted) indices.insert(indices.end(), t.begin(), t.end());
    }
    (wanted ? translucent_count_ : opaque_count_) = static_cast<int>(indices.size()) - (wanted ? opaque_count_ : 0);
  }
  looks_.add_indices(look, looks, scene.triangles, indices);
  first_edge_ = indices.size();
  has_edges_ = scene.wireframe;
  edge_count_ = 0;
  if (has_edges_) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(scene.triangles.size() * 3);
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
      const mesh::Triangle& t = scene.triangles[i];
      if ((!looks || !is_of_look[i]) && clear(t)) continue;
      for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(std::minmax(t[k], t[(k + 1) % 3]));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges) indices.insert(indices.end(), {a, b});
    edge_count_ = static_cast<int>(edges.size() * 2);
  }
  glBindVertexArray(vertex_array_);
  fill(GL_ELEMENT_ARRAY_BUFFER, indices_, indices, GL_STATIC_DRAW);
  looks_.upload(look, vertex_count_);
  glBindVertexArray(0);
}

base::Status MeshPass::upload(const Scene& scene) {
  const std::size_t count = scene.positions.size();
  if (scene.normals.size() != count || (!scene.overlay.empty() && scene.overlay.size() != count)) {
    return base::Error{"normals or colours do not fit the vertices", "scene", "give one a vertex"};
  }
  const bool new_shape = scene.shape_number == 0 || scene.shape_number != shape_number_ || count != vertex_count_ ||
                         scene.triangles.size() != triangle_count_ || (scene.wireframe && !has_edges_) ||
                         scene.clay != clay_;
  if (new_shape) {
    if (const Appearance* look = scene.appearance) {
      const auto known = [&](std::uint16_t s) { return s < look->surfaces.size(); };
      const bool fits = !look->surfaces.empty() &&
                        (look->surface_of_vertex.empty() || look->surface_of_vertex.size() == count) &&
                        (look->gaze.empty() || look->gaze.size() == count) &&
                        (look->opacity.empty() || look->opacity.size() == count) &&
                        std::all_of(look->surface_of_vertex.begin(), look->surface_of_vertex.end(), known) &&
                        LookPass::fits(*look, count, scene.triangles.size());
      if (!fits) return base::Error{"the appearance does not fit the vertices", "scene", "make it from this mesh"};
    }
    for (const mesh::Triangle& t : scene.triangles) {
      if (t[0] >= count || t[1] >= count || t[2] >= count) {
        return base::Error{"a triangle uses a vertex that does not exist", "scene", "give the positions of this mesh"};
      }
    }
    vertex_count_ = count;
    triangle_count_ = scene.triangles.size();
    clay_ = scene.clay;
    upload_shape(scene);
  }
  const bool new_pose = new_shape || scene.pose_number == 0 || scene.pose_number != pose_number_;
  if (new_pose) {
    fill(positions_, scene.positions);
    fill(normals_, scene.normals);
  }
  const bool clear = scene.overlay.empty();
  if (new_shape || clear != overlay_is_clear_ ||
      (!clear && (scene.overlay_number == 0 || scene.overlay_number != overlay_number_))) {
    std::vector<Bytes4> colors(count, Bytes4{0, 0, 0, 0});
    std::transform(scene.overlay.begin(), scene.overlay.end(), colors.begin(), pack);
    fill(GL_ARRAY_BUFFER, overlay_, colors, GL_DYNAMIC_DRAW);
  }
  shape_number_ = scene.shape_number;
  pose_number_ = scene.pose_number;
  overlay_number_ = scene.overlay_number;
  overlay_is_clear_ = clear;
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
  looks_.draw_opaque(view);
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (wireframe && has_edges_) {
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
  if (translucent_count_ == 0 && !looks_.blends()) return;
  glBindVertexArray(vertex_array_);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  looks_.draw_blended(view);
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
