#include "ui/render/gl/mesh_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <utility>

#include "ui/render/gl/shaders.h"

namespace penpose::render {
namespace {

using Bytes4 = std::array<std::uint8_t, 4>;

std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

/// Square roots keep finer steps in the dark; the shader squares.
Bytes4 pack(const Color& c) {
  return {to_byte(std::sqrt(std::max(c.r, 0.0F))), to_byte(std::sqrt(std::max(c.g, 0.0F))),
          to_byte(std::sqrt(std::max(c.b, 0.0F))), to_byte(c.a)};
}

template <typename T>
void fill(unsigned target, unsigned buffer, const std::vector<T>& data, unsigned usage) {
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), usage);
}

void fill(unsigned buffer, std::span<const glm::vec3> data) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STREAM_DRAW);
}

const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // what OpenGL calls a pointer is an offset here
}

}  // namespace

View make_view(std::span<const glm::vec3> positions, const geometry::Camera& camera) {
  geometry::Box box;
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};
  for (const glm::vec3& p : positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  if (!positions.empty()) {
    box.add(geometry::ModelPoint(low));
    box.add(geometry::ModelPoint(high));
  } else {
    box.add(geometry::ModelPoint(0));
  }
  const double diagonal = box.diagonal() > 0 ? box.diagonal() : geometry::distance(camera.eye(), box.center());
  View view;
  view.middle = glm::vec3(box.center());
  view.scale = static_cast<float>(diagonal > 0 ? 1.0 / diagonal : 1.0);
  const double scale = static_cast<double>(view.scale);
  const auto scaled = [&](const geometry::ModelPoint& p) { return (p - geometry::ModelPoint(view.middle)) * scale; };
  const glm::dvec3 eye = scaled(camera.eye());
  glm::dmat4 to_view(1);
  for (int i = 0; i < 3; ++i) {
    to_view[i][0] = camera.right()[i];
    to_view[i][1] = camera.up()[i];
    to_view[i][2] = -camera.forward()[i];
  }
  to_view[3] = to_view * glm::dvec4(-eye, 1.0);
  view.to_view = glm::mat4(to_view);
  // The planes hug a sphere around the box, so that 24 bits of depth are spent on the model.
  const double middle_depth = -to_view[3][2];
  const double far = std::max(middle_depth + 0.51, 0.02);
  const double near = std::max(middle_depth - 0.51, far * 1e-3);
  const double half_height = camera.units_per_px(1.0) * camera.viewport().height * 0.5;
  const double half_width = half_height * camera.viewport().width / camera.viewport().height;
  glm::dmat4 to_clip(0);
  to_clip[0][0] = 1.0 / half_width;
  to_clip[1][1] = 1.0 / half_height;
  to_clip[2][2] = -(far + near) / (far - near);
  to_clip[2][3] = -1;
  to_clip[3][2] = -2 * far * near / (far - near);
  view.to_clip = glm::mat4(to_clip);
  view.depth_to_z = glm::vec2(1.0 / far - 1.0 / near, 1.0 / near);
  view.image_plane = glm::vec2(half_width, half_height);
  return view;
}

base::Result<MeshPass> MeshPass::make() {
  const auto attributes = {"position", "normal", "base_color", "finish", "overlay"};
  auto surface = GlProgram::make(k_mesh_vertex, k_mesh_fragment, attributes);
  if (!surface) return surface.error();
  auto wire = GlProgram::make(k_mesh_vertex, k_wire_fragment, attributes);
  if (!wire) return wire.error();
  MeshPass made;
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
  // Opaque triangles, then translucent ones, then (when asked for) the edges of the opaque ones.
  std::vector<std::uint32_t> indices;
  indices.reserve(scene.triangles.size() * (scene.wireframe ? 6 : 3));
  const auto clear = [&](const mesh::Triangle& t) { return surface_of(t[0]).base_color.a < 1.0F; };
  for (const bool wanted : {false, true}) {
    for (const mesh::Triangle& t : scene.triangles) {
      if (clear(t) == wanted) indices.insert(indices.end(), t.begin(), t.end());
    }
    (wanted ? translucent_count_ : opaque_count_) = static_cast<int>(indices.size()) - (wanted ? opaque_count_ : 0);
  }
  has_edges_ = scene.wireframe;
  edge_count_ = 0;
  if (has_edges_) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(scene.triangles.size() * 3);
    for (const mesh::Triangle& t : scene.triangles) {
      if (clear(t)) continue;
      for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(std::minmax(t[k], t[(k + 1) % 3]));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges) indices.insert(indices.end(), {a, b});
    edge_count_ = static_cast<int>(edges.size() * 2);
  }
  glBindVertexArray(vertex_array_);
  fill(GL_ELEMENT_ARRAY_BUFFER, indices_, indices, GL_STATIC_DRAW);
  glBindVertexArray(0);
}

base::Status MeshPass::upload(const Scene& scene) {
  const std::size_t count = scene.positions.size();
  if (scene.normals.size() != count || (!scene.overlay.empty() && scene.overlay.size() != count)) {
    return base::Error{"normals or colours do not fit the vertices", "scene", "give one a vertex"};
  }
  const bool new_shape = scene.shape_number == 0 || scene.shape_number != shape_number_ || count != vertex_count_ ||
                         scene.triangles.size() != triangle_count_ || (scene.wireframe && !has_edges_);
  if (new_shape) {
    if (const Appearance* look = scene.appearance) {
      const auto known = [&](std::uint16_t s) { return s < look->surfaces.size(); };
      const bool fits = !look->surfaces.empty() &&
                        (look->surface_of_vertex.empty() || look->surface_of_vertex.size() == count) &&
                        (look->gaze.empty() || look->gaze.size() == count) &&
                        (look->opacity.empty() || look->opacity.size() == count) &&
                        std::all_of(look->surface_of_vertex.begin(), look->surface_of_vertex.end(), known);
      if (!fits) return base::Error{"the appearance does not fit the vertices", "scene", "make it from this mesh"};
    }
    for (const mesh::Triangle& t : scene.triangles) {
      if (t[0] >= count || t[1] >= count || t[2] >= count) {
        return base::Error{"a triangle uses a vertex that does not exist", "scene", "give the positions of this mesh"};
      }
    }
    vertex_count_ = count;
    triangle_count_ = scene.triangles.size();
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

void MeshPass::set_view(const GlProgram& program, const View& view) const {
  program.use();
  program.set("middle", view.middle.x, view.middle.y, view.middle.z);
  program.set("scale", view.scale);
  program.set_matrix("to_view", glm::value_ptr(view.to_view));
  program.set_matrix("to_clip", glm::value_ptr(view.to_clip));
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
  set_view(surface_, view);
  surface_.set("opaque_pass", 1.0F);
  glDrawElements(GL_TRIANGLES, opaque_count_, GL_UNSIGNED_INT, nullptr);
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (wireframe && has_edges_) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    set_view(wire_, view);
    glDrawElements(GL_LINES, edge_count_, GL_UNSIGNED_INT,
                   offset(static_cast<std::size_t>(opaque_count_ + translucent_count_) * sizeof(std::uint32_t)));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
  }
  glBindVertexArray(0);
}

void MeshPass::draw_translucent(const View& view) const {
  if (translucent_count_ == 0) return;
  glBindVertexArray(vertex_array_);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  set_view(surface_, view);
  surface_.set("opaque_pass", 0.0F);
  glDrawElements(GL_TRIANGLES, translucent_count_, GL_UNSIGNED_INT,
                 offset(static_cast<std::size_t>(opaque_count_) * sizeof(std::uint32_t)));
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
}

}  // namespace penpose::render
