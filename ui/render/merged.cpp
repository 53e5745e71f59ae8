#include "ui/render/merged.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace penpose::render {
namespace {

/// Adds values of `count` vertices; those that there are none of get `usual`. Nothing where no part has any.
template <typename Value>
void append_values(std::vector<Value>& to, const std::vector<Value>& values, std::size_t before, std::size_t count,
                   const Value& usual) {
  if (values.empty() && to.empty()) return;
  to.resize(before, usual);
  to.insert(to.end(), values.begin(), values.end());
  to.resize(before + count, usual);
}

void append_look(document::Look& to, const document::Look& look, std::size_t vertices, std::size_t count) {
  const std::size_t images = to.images.size();
  to.images.insert(to.images.end(), look.images.begin(), look.images.end());
  const auto shift = [&](std::optional<document::TextureUse>& use) {
    if (use) use->image += images;
  };
  for (document::Surface surface : look.surfaces) {
    shift(surface.texture);
    if (surface.toon) shift(surface.toon->shade_texture);
    if (surface.toon) shift(surface.toon->outline_texture);
    to.surfaces.push_back(std::move(surface));
  }
  for (std::size_t set = 0; set < to.coordinates.size(); ++set)
    append_values(to.coordinates[set], look.coordinates[set], vertices, count, {});
  append_values(to.colors, look.colors, vertices, count, {1, 1, 1, 1});
}

/// Adds the soft shadows of a part. On the ground there are those of the one in whose space all is drawn.
void append_light(std::shared_ptr<BakedLight>& to, const ScenePart& part, std::size_t vertices, std::size_t count) {
  const auto& light = part.appearance->light;
  if (!light && !to) return;
  if (!to) to = std::make_shared<BakedLight>();
  append_values(to->sky, light ? light->sky : std::vector<std::uint8_t>(), vertices, count, std::uint8_t{255});
  if (!light || !(part.placement == geometry::Placement{})) return;
  to->ground = light->ground;
  to->half_side = light->half_side;
  to->ground_shade = light->ground_shade;
}

/// Adds the batches of a part, whose surfaces and triangles stand behind those of the parts before.
void append_batches(Appearance& to, const Appearance& part, std::size_t surfaces, std::size_t triangles) {
  const auto first = static_cast<std::uint32_t>(to.look_triangles.size());
  for (LookBatch batch : part.batches) {
    batch.surface += static_cast<std::uint32_t>(surfaces);
    batch.first += first;
    to.batches.push_back(batch);
  }
  for (const std::uint32_t triangle : part.look_triangles)
    to.look_triangles.push_back(triangle + static_cast<std::uint32_t>(triangles));
}

}  // namespace

MergedShape merged_shape(std::span<const ScenePart> parts) {
  MergedShape merged;
  Appearance& to = merged.appearance;
  auto look = std::make_shared<document::Look>();
  std::shared_ptr<BakedLight> light;
  std::size_t vertices = 0;
  for (const ScenePart& part : parts) {
    const Appearance& from = *part.appearance;
    const std::size_t count = part.model->mesh->vertex_count();
    const std::size_t surfaces = to.surfaces.size();
    to.surfaces.insert(to.surfaces.end(), from.surfaces.begin(), from.surfaces.end());
    for (std::size_t v = 0; v < count; ++v) {
      const std::size_t surface = from.surface_of_vertex.empty() ? 0 : from.surface_of_vertex[v];
      to.surface_of_vertex.push_back(static_cast<std::uint16_t>(surfaces + surface));
    }
    append_values(to.gaze, from.gaze, vertices, count, 1.0F);
    append_values(to.opacity, from.opacity, vertices, count, 1.0F);
    append_light(light, part, vertices, count);
    append_batches(to, from, look->surfaces.size(), merged.triangles.size());
    append_look(*look, from.look ? *from.look : document::Look(), vertices, count);
    for (const mesh::Triangle& t : part.model->mesh->triangles()) {
      mesh::Triangle moved = t;
      for (auto& corner : moved) corner += static_cast<std::uint32_t>(vertices);
      merged.triangles.push_back(moved);
    }
    vertices += count;
  }
  if (!to.batches.empty()) to.look = std::move(look);
  to.light = std::move(light);
  return merged;
}

MergedPose merged_pose(std::span<const ScenePart> parts) {
  MergedPose merged;
  for (const ScenePart& part : parts) {
    if (part.placement == geometry::Placement{}) {
      merged.positions.insert(merged.positions.end(), part.positions.begin(), part.positions.end());
      merged.normals.insert(merged.normals.end(), part.normals.begin(), part.normals.end());
      continue;
    }
    // The images of the axes, so that a vertex costs nine products.
    const geometry::Placement& placement = part.placement;
    const glm::vec3 x = turned(placement, {1, 0, 0});
    const glm::vec3 y = turned(placement, {0, 1, 0});
    const glm::vec3 z = turned(placement, {0, 0, 1});
    const glm::vec3 at = placement.at;
    const auto scale = static_cast<float>(placement.scale);
    for (const glm::vec3& p : part.positions) merged.positions.push_back(at + scale * (p.x * x + p.y * y + p.z * z));
    for (const glm::vec3& n : part.normals) merged.normals.push_back(n.x * x + n.y * y + n.z * z);
  }
  return merged;
}

}  // namespace penpose::render
