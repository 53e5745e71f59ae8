#include "ui/render/cpu/outlines.h"

#include <algorithm>
#include <cmath>

namespace penpose::render {

void Outlines::take(const DrawList& list, const document::Look* look, const KeptPictures<TextureMap>& textures,
                    std::size_t vertex_count) {
  widths_.clear();
  for (const DrawList::Batch& batch : list.batches) {
    const document::Surface& surface = look->surfaces[batch.of.surface];
    if (!has_outline(surface)) continue;
    widths_.resize(vertex_count, glm::vec2(0));
    const document::Toon& toon = *surface.toon;
    const auto& use = toon.outline_texture;
    const TextureMap* map = use ? textures.find(*look, *use) : nullptr;
    const auto& coordinates = look->coordinates[use && use->coordinates == 1 ? 1 : 0];
    const TextureTransform place = use ? transform_of(*use) : TextureTransform();
    const auto width = static_cast<float>(toon.outline_width);
    for (const mesh::Triangle& t : batch.triangles) {
      for (const std::uint32_t v : t) {
        float share = 1;
        if (map != nullptr && !coordinates.empty()) {
          const glm::vec2 at = place.along_u * coordinates[v][0] + place.along_v * coordinates[v][1] + place.shift;
          share = std::sqrt(std::max(map->sample(*use, at, glm::vec2(0), glm::vec2(0)).g, 0.0F));
        }
        widths_[v] =
            toon.outline == document::OutlineWidth::world ? glm::vec2(width * share, 0) : glm::vec2(0, width * share);
      }
    }
  }
}

void Outlines::place(const Raster& raster, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                     std::vector<ScreenVertex>& placed) {
  if (empty()) return;
  positions_.resize(positions.size());
  const float per_depth = 2 * raster.view.image_plane.y / raster.view.scale;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const float depth = widths_[v].y > 0 ? -raster.in_view(positions[v]).z : 0.0F;
    positions_[v] = positions[v] + normals[v] * (widths_[v].x + widths_[v].y * per_depth * depth);
  }
  place_vertices(raster, positions_, normals, placed_);
  placed.insert(placed.end(), placed_.begin(), placed_.end());
}

}  // namespace penpose::render
