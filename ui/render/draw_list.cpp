#include "ui/render/draw_list.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/base/math.h"

namespace penpose::render {
namespace {

/// Whether the look is one of a mesh of that many vertices and triangles.
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

bool appearance_fits(const Appearance& look, std::size_t vertices, std::size_t triangles) {
  const auto known = [&](std::uint16_t s) { return s < look.surfaces.size(); };
  const auto fits = [&](std::size_t size) { return size == 0 || size == vertices; };
  return !look.surfaces.empty() && fits(look.surface_of_vertex.size()) && fits(look.gaze.size()) &&
         fits(look.opacity.size()) && (!look.light || fits(look.light->sky.size())) &&
         std::all_of(look.surface_of_vertex.begin(), look.surface_of_vertex.end(), known) &&
         look_fits(look, vertices, triangles);
}

const Surface& surface_of(const Scene& scene, std::size_t vertex) {
  static const Surface plain;
  if (scene.appearance == nullptr) return plain;
  const Appearance& look = *scene.appearance;
  return look.surfaces[look.surface_of_vertex.empty() ? 0 : look.surface_of_vertex[vertex]];
}

}  // namespace

base::Result<SceneChanges> SceneTracker::look_at(const Scene& scene) {
  const std::size_t count = scene.positions.size();
  if (scene.normals.size() != count || (!scene.overlay.empty() && scene.overlay.size() != count)) {
    return base::Error{"normals or colours do not fit the vertices", "scene", "give one a vertex"};
  }
  SceneChanges changes;
  changes.shape = scene.shape_number == 0 || scene.shape_number != shape_ || count != vertices_ ||
                  scene.triangles.size() != triangles_ || (scene.wireframe && !edges_) || scene.clay != clay_ ||
                  scene.matcap != matcap_;
  if (changes.shape) {
    if (scene.appearance != nullptr && !appearance_fits(*scene.appearance, count, scene.triangles.size())) {
      return base::Error{"the appearance does not fit the vertices", "scene", "make it from this mesh"};
    }
    for (const mesh::Triangle& t : scene.triangles) {
      if (t[0] < count && t[1] < count && t[2] < count) continue;
      return base::Error{"a triangle uses a vertex that does not exist", "scene", "give the positions of this mesh"};
    }
    edges_ = scene.wireframe;
  }
  changes.pose = changes.shape || scene.pose_number == 0 || scene.pose_number != pose_;
  const bool clear = scene.overlay.empty();
  changes.overlay = changes.shape || clear != overlay_is_clear_ ||
                    (!clear && (scene.overlay_number == 0 || scene.overlay_number != overlay_));
  vertices_ = count;
  triangles_ = scene.triangles.size();
  clay_ = scene.clay;
  matcap_ = scene.matcap;
  shape_ = scene.shape_number;
  pose_ = scene.pose_number;
  overlay_ = scene.overlay_number;
  overlay_is_clear_ = clear;
  return changes;
}

DrawList make_draw_list(const Scene& scene) {
  DrawList list;
  const Appearance* appearance = scene.appearance;
  const bool looks = appearance != nullptr && appearance->look && !scene.clay && !scene.matcap;
  std::vector<bool> is_of_look(looks ? scene.triangles.size() : 0, false);
  if (looks) {
    for (const std::uint32_t t : appearance->look_triangles) is_of_look[t] = true;
    for (const LookBatch& one : appearance->batches) {
      DrawList::Batch batch{one, {}};
      batch.triangles.reserve(one.count);
      for (const std::uint32_t i : std::span(appearance->look_triangles).subspan(one.first, one.count)) {
        batch.triangles.push_back(scene.triangles[i]);
      }
      if (appearance->look->surfaces[one.surface].alpha == document::AlphaMode::blend) {
        list.blended.push_back(list.batches.size());
      }
      list.batches.push_back(std::move(batch));
    }
  }
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const mesh::Triangle& t = scene.triangles[i];
    const bool clear = (!looks || !is_of_look[i]) && surface_of(scene, t[0]).base_color.a < 1.0F;
    if (clear) list.translucent.push_back(t);
    if (!clear && (!looks || !is_of_look[i])) list.opaque.push_back(t);
    if (clear || !scene.wireframe) continue;
    for (std::size_t k = 0; k < 3; ++k) list.edges.emplace_back(std::minmax(t[k], t[(k + 1) % 3]));
  }
  std::sort(list.edges.begin(), list.edges.end());
  list.edges.erase(std::unique(list.edges.begin(), list.edges.end()), list.edges.end());
  return list;
}

namespace internal {

bool order_batch(DrawList::Batch& batch, const Scene& scene, const View& view, double& depth) {
  // Away from the eye is against z.
  const glm::vec3 away{-view.to_view[0][2], -view.to_view[1][2], -view.to_view[2][2]};
  std::vector<std::pair<float, mesh::Triangle>> sorted;
  sorted.reserve(batch.triangles.size());
  depth = 0;
  for (const mesh::Triangle& t : batch.triangles) {
    const float one = glm::dot(away, scene.positions[t[0]] + scene.positions[t[1]] + scene.positions[t[2]]);
    depth += static_cast<double>(one) / static_cast<double>(batch.triangles.size());
    sorted.emplace_back(one, t);
  }
  const auto farther = [](const auto& one, const auto& other) { return one.first > other.first; };
  if (std::is_sorted(sorted.begin(), sorted.end(), farther)) return false;
  std::stable_sort(sorted.begin(), sorted.end(), farther);
  std::transform(sorted.begin(), sorted.end(), batch.triangles.begin(), [](const auto& one) { return one.second; });
  return true;
}

void order_batches(DrawList& list, const std::vector<double>& depths) {
  std::sort(list.blended.begin(), list.blended.end());
  std::stable_sort(list.blended.begin(), list.blended.end(),
                   [&](std::size_t a, std::size_t b) { return depths[a] > depths[b]; });
}

}  // namespace internal

float least_alpha(const document::Surface& surface) {
  if (surface.alpha == document::AlphaMode::opaque) return -1.0F;
  return surface.alpha == document::AlphaMode::mask ? static_cast<float>(surface.alpha_cutoff) : k_nearly_opaque;
}

TextureTransform transform_of(const document::TextureUse& use) {
  // Shift, turn, scale. The turn counts against the clock where v runs down.
  const double sine = base::sin(use.rotation);
  const double cosine = base::cos(use.rotation);
  return {glm::vec2(cosine * use.scale[0], -sine * use.scale[0]), glm::vec2(sine * use.scale[1], cosine * use.scale[1]),
          glm::vec2(use.offset[0], use.offset[1])};
}

std::vector<VertexFinish> vertex_finish(const Scene& scene) {
  std::vector<VertexFinish> finish(scene.positions.size());
  const Appearance* look = scene.appearance;
  const bool gaze = look != nullptr && !look->gaze.empty();
  const bool opacity = look != nullptr && !look->opacity.empty();
  for (std::size_t v = 0; v < finish.size(); ++v) {
    Surface surface = surface_of(scene, v);
    // Of a ball's light only lashes and films keep their own colour.
    if (scene.matcap && surface.base_color.a >= 1) surface.base_color = {1, 1, 1, 1};
    finish[v] = {pack(surface.base_color),
                 Bytes4{to_byte(surface.roughness), to_byte(surface.metallic), to_byte(gaze ? look->gaze[v] : 1.0F),
                        to_byte(opacity ? look->opacity[v] : 1.0F)}};
  }
  return finish;
}

std::vector<Bytes4> vertex_light(const Scene& scene) {
  std::vector<Bytes4> light(scene.positions.size(), Bytes4{255, 0, 0, 0});
  const Appearance* look = scene.appearance;
  if (look == nullptr) return light;
  const bool baked = look->light && !look->light->sky.empty();
  for (std::size_t v = 0; v < light.size(); ++v) {
    if (baked) light[v][0] = look->light->sky[v];
    if (!look->gaze.empty()) light[v][1] = to_byte((0.97F - look->gaze[v]) / 0.07F);
  }
  return light;
}

bool has_toon(const DrawList& list, const Appearance* appearance) {
  return std::any_of(list.batches.begin(), list.batches.end(), [&](const DrawList::Batch& batch) {
    return appearance->look->surfaces[batch.of.surface].toon.has_value();
  });
}

bool has_outline(const document::Surface& surface) {
  return surface.toon && surface.toon->outline != document::OutlineWidth::none && surface.toon->outline_width > 0 &&
         surface.alpha != document::AlphaMode::blend;
}

glm::vec2 outline_reach(const document::Toon& toon, const View& view) {
  const auto width = static_cast<float>(toon.outline_width);
  if (toon.outline == document::OutlineWidth::world) return {width * view.scale, 0};
  return {0, width * 2 * view.image_plane.y};
}

std::vector<Bytes4> vertex_tint(const document::Look& look, std::size_t vertex_count) {
  std::vector<Bytes4> tint(vertex_count, Bytes4{255, 255, 255, 255});
  for (std::size_t v = 0; v < look.colors.size(); ++v) {
    const auto& c = look.colors[v];
    tint[v] = pack({c[0], c[1], c[2], c[3]});
  }
  return tint;
}

}  // namespace penpose::render
