#include "ui/render/cpu/triangles/changed_tiles.h"

#include <algorithm>

#include "ui/render/cpu/triangles/draw_items.h"

namespace penpose::render {
namespace {

bool same(const ScreenVertex& a, const ScreenVertex& b) {
  return a.corner.x == b.corner.x && a.corner.y == b.corner.y && a.corner.inverse_depth == b.corner.inverse_depth &&
         a.normal == b.normal;
}

}  // namespace

std::optional<std::vector<bool>> changed_tiles(const DrawList& list, geometry::Viewport size,
                                               std::span<const ScreenVertex> before,
                                               std::span<const ScreenVertex> now) {
  std::vector<bool> moved(now.size());
  for (std::size_t v = 0; v < now.size(); ++v) {
    if (before[v].corner.x == k_must_be_clipped || now[v].corner.x == k_must_be_clipped) return std::nullopt;
    moved[v] = !same(before[v], now[v]);
  }
  const int columns = (size.width + DrawItems::k_tile_width - 1) / DrawItems::k_tile_width;
  const int rows = (size.height + DrawItems::k_tile_height - 1) / DrawItems::k_tile_height;
  std::vector<bool> changed(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  const auto mark = [&](const mesh::Triangle& t, std::span<const ScreenVertex> vertices) {
    const PxRect px = shared_part(px_around({vertices[t[0]].corner, vertices[t[1]].corner, vertices[t[2]].corner}),
                                  {0, 0, size.width, size.height});
    if (px.empty()) return;
    const PxRect tiles = tiles_of(px);
    for (int y = tiles.top; y < tiles.bottom; ++y) {
      for (int x = tiles.left; x < tiles.right; ++x) changed[static_cast<std::size_t>(y * columns + x)] = true;
    }
  };
  const auto mark_moved = [&](const std::vector<mesh::Triangle>& triangles) {
    for (const mesh::Triangle& t : triangles) {
      if (!moved[t[0]] && !moved[t[1]] && !moved[t[2]]) continue;
      mark(t, before);
      mark(t, now);
    }
  };
  mark_moved(list.opaque);
  mark_moved(list.translucent);
  for (const DrawList::Batch& batch : list.batches) mark_moved(batch.triangles);
  return changed;
}

}  // namespace penpose::render
