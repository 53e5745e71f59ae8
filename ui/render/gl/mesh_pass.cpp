#include "ui/render/gl/mesh_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <utility>

#include "core/base/math.h"
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

constexpr unsigned k_coordinates_place = 5;
constexpr unsigned k_tint_place = 6;
/// Of what is blended, all that is as good as opaque hides what is behind it.
constexpr float k_nearly_opaque = 0.98F;
constexpr float k_nearly_clear = 0.004F;

bool look_fits(const Appearance& appearance, std::size_t vertices, std::size_t triangles) {
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
  auto surface = GlProgram::make(k_mesh_vertex, k_mesh_fragment, attributes, k_lights);
  if (!surface) return surface.error();
  auto wire = GlProgram::make(k_mesh_vertex, k_wire_fragment, attributes);
  if (!wire) return wire.error();
  auto looks =
      GlProgram::make(k_look_vertex, k_look_fragment,
                      {"position", "normal", "base_color", "finish", "overlay", "coordinates", "tint"}, k_lights);
  if (!looks) return looks.error();
  MeshPass made;
  made.looks_ = std::move(*looks);
  made.surface_ = std::move(*surface);
  made.wire_ = std::move(*wire);
  glGenVertexArrays(1, &made.vertex_array_);
  for (unsigned* buffer : {&made.positions_, &made.normals_, &made.finish_, &made.overlay_, &made.indices_,
                           &made.coordinates_, &made.tint_}) {
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
      textures_(std::move(other.textures_)),
      look_(std::move(other.look_)),
      batches_(std::move(other.batches_)),
      blended_(std::move(other.blended_)),
      coordinates_(std::exchange(other.coordinates_, 0)),
      tint_(std::exchange(other.tint_, 0)),
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
  for (const unsigned buffer : {positions_, normals_, finish_, overlay_, indices_, coordinates_, tint_}) {
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
  batches_.clear();
  blended_.clear();
  for (const LookBatch& one : looks ? look.batches : std::vector<LookBatch>()) {
    Batch batch{one, indices.size(), {}};
    const bool blends = look.look->surfaces[one.surface].alpha == document::AlphaMode::blend;
    for (const std::uint32_t i : std::span(look.look_triangles).subspan(one.first, one.count)) {
      const mesh::Triangle& t = scene.triangles[i];
      indices.insert(indices.end(), t.begin(), t.end());
      if (blends) batch.triangles.push_back(t);
    }
    if (blends) blended_.push_back(batches_.size());
    batches_.push_back(std::move(batch));
  }
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
  glBindVertexArray(0);
  upload_look(look);
}

void MeshPass::upload_look(const Appearance& appearance) {
  look_ = batches_.empty() ? nullptr : appearance.look;
  glBindVertexArray(vertex_array_);
  if (!look_) {
    // Models without pictures take no memory for them; clay keeps them, because one looks at both in turn.
    if (!appearance.look) textures_.clear();
    glDisableVertexAttribArray(k_coordinates_place);
    glDisableVertexAttribArray(k_tint_place);
    fill(GL_ARRAY_BUFFER, coordinates_, std::vector<float>(), GL_STATIC_DRAW);
    fill(GL_ARRAY_BUFFER, tint_, std::vector<float>(), GL_STATIC_DRAW);
    glBindVertexArray(0);
    return;
  }
  const auto& [first, second] = look_->coordinates;
  std::vector<std::array<float, 4>> coordinates(vertex_count_, std::array<float, 4>{0, 0, 0, 0});
  for (std::size_t v = 0; v < vertex_count_; ++v) {
    if (!first.empty()) std::copy(first[v].begin(), first[v].end(), coordinates[v].begin());
    if (!second.empty()) std::copy(second[v].begin(), second[v].end(), coordinates[v].begin() + 2);
  }
  std::vector<Bytes4> tint(vertex_count_, Bytes4{255, 255, 255, 255});
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
  glBindVertexArray(0);
  textures_.keep(*look_, appearance.batches);
}

void MeshPass::order(const Scene& scene, const View& view) {
  if (blended_.empty()) return;
  // Away from the eye is against z.
  const glm::vec3 away{-view.to_view[0][2], -view.to_view[1][2], -view.to_view[2][2]};
  std::vector<double> depth_of(batches_.size(), 0);
  std::vector<std::pair<float, mesh::Triangle>> sorted;
  glBindVertexArray(vertex_array_);
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
  glBindVertexArray(0);
  std::sort(blended_.begin(), blended_.end());
  std::stable_sort(blended_.begin(), blended_.end(),
                   [&](std::size_t a, std::size_t b) { return depth_of[a] > depth_of[b]; });
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
                        look_fits(*look, count, scene.triangles.size());
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
  if (look_) {
    set_view(looks_, view);
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
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (wireframe && has_edges_) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    set_view(wire_, view);
    glDrawElements(GL_LINES, edge_count_, GL_UNSIGNED_INT, offset(first_edge_ * sizeof(std::uint32_t)));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
  }
  glBindVertexArray(0);
}

void MeshPass::draw_batch(const Batch& batch, float least_alpha) const {
  const document::Surface& surface = look_->surfaces[batch.of.surface];
  const auto single = [](double value) { return static_cast<float>(value); };
  const auto& color = surface.base_color;
  const bool textured = surface.texture && textures_.bind(*look_, *surface.texture);
  if (textured) {
    // KHR_texture_transform: shift, turn, scale. Its turn counts against the clock where v runs down.
    const document::TextureUse& use = *surface.texture;
    const double sine = base::sin(use.rotation);
    const double cosine = base::cos(use.rotation);
    looks_.set("along_u", single(cosine * use.scale[0]), single(-sine * use.scale[0]));
    looks_.set("along_v", single(sine * use.scale[1]), single(cosine * use.scale[1]));
    looks_.set("shift", single(use.offset[0]), single(use.offset[1]));
    looks_.set("second_set", use.coordinates == 1 ? 1.0F : 0.0F);
  }
  const bool lost = surface.texture && !textured;  // its picture cannot be read: grey
  const double share = lost ? 0.6 : 1.0;
  looks_.set("picture", 0);
  looks_.set("textured", textured ? 1.0F : 0.0F);
  looks_.set("factor", single(color[0] * share), single(color[1] * share), single(color[2] * share));
  looks_.set("opacity", lost ? 1.0F : single(color[3]));
  looks_.set("least_alpha", least_alpha);
  looks_.set("unlit", surface.unlit && !lost ? 1.0F : 0.0F);
  looks_.set("roughness", batch.of.roughness);
  looks_.set("metallic", batch.of.metallic);
  if (surface.double_sided) {
    glDisable(GL_CULL_FACE);
  } else {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
  }
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.of.count * 3), GL_UNSIGNED_INT,
                 offset(batch.first_index * sizeof(std::uint32_t)));
}

void MeshPass::draw_translucent(const View& view) const {
  if (translucent_count_ == 0 && blended_.empty()) return;
  glBindVertexArray(vertex_array_);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  if (!blended_.empty()) {
    set_view(looks_, view);
    for (const std::size_t b : blended_) draw_batch(batches_[b], k_nearly_clear);
    glDisable(GL_CULL_FACE);
    glBindTexture(GL_TEXTURE_2D, 0);
  }
  if (translucent_count_ > 0) {
    set_view(surface_, view);
    surface_.set("opaque_pass", 0.0F);
    glDrawElements(GL_TRIANGLES, translucent_count_, GL_UNSIGNED_INT,
                   offset(static_cast<std::size_t>(opaque_count_) * sizeof(std::uint32_t)));
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
}

}  // namespace penpose::render
