#include "ui/render/cpu/triangles/draw_items.h"

#include <algorithm>
#include <utility>

namespace penpose::render {

PxRect DrawItems::tile(int index) const {
  const int left = index % columns_ * k_tile_width;
  const int top = index / columns_ * k_tile_height;
  return {left, top, std::min(left + k_tile_width, size_.width), std::min(top + k_tile_height, size_.height)};
}

const Segment& DrawItems::segment_of(std::uint32_t item) const {
  const auto after = std::upper_bound(segments_.begin(), segments_.end(), item,
                                      [](std::uint32_t one, const Segment& s) { return one < s.first_item; });
  return *(after - 1);
}

void DrawItems::sort(const Raster& raster, std::span<const glm::vec3> positions, std::span<const ScreenVertex> vertices,
                     std::vector<Segment> segments, const std::vector<bool>& wanted) {
  size_ = raster.size;
  columns_ = (size_.width + k_tile_width - 1) / k_tile_width;
  rows_ = (size_.height + k_tile_height - 1) / k_tile_height;
  segments_ = std::move(segments);
  pieces_.clear();
  const PxRect picture{0, 0, size_.width, size_.height};
  starts_.assign(static_cast<std::size_t>(tile_count()) + 1, 0);
  in_tiles_.clear();
  const auto take_if_seen = [&](const Segment& segment, const Corners& c, std::uint32_t number) {
    const PxRect px = shared_part(px_around(c), picture);
    if (px.empty()) return;
    const std::int64_t area = twice_area(c);
    if (area == 0 || (segment.culls_back && area > 0) || (segment.outline && area < 0)) return;
    const PxRect tiles = tiles_of(px);
    for (int y = tiles.top; y < tiles.bottom; ++y) {
      for (int x = tiles.left; x < tiles.right; ++x) {
        const auto tile = static_cast<std::uint32_t>(y * columns_ + x);
        if (!wanted.empty() && !wanted[tile]) continue;
        in_tiles_.push_back({tile, number});
        ++starts_[tile + 1];
      }
    }
  };
  for (const Segment& segment : segments_) {
    std::uint32_t item = segment.first_item;
    for (const mesh::Triangle& t : segment.triangles) {
      const Corners corners = corners_of(segment, t, vertices);
      if (corners[0].x != k_must_be_clipped && corners[1].x != k_must_be_clipped && corners[2].x != k_must_be_clipped) {
        take_if_seen(segment, corners, item++);
        continue;
      }
      if (segment.outline) {
        ++item;  // so near that its line would fill the picture
        continue;
      }
      std::size_t piece = pieces_.size();
      add_pieces(raster, positions, t, item++, pieces_);
      for (; piece < pieces_.size(); ++piece) {
        take_if_seen(segment, pieces_[piece].corners, k_piece | static_cast<std::uint32_t>(piece));
      }
    }
  }
  // Then each tile's together, in the same order.
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  items_.resize(in_tiles_.size());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end());
  for (const InTile& one : in_tiles_) items_[next[one.tile]++] = one.item;
}

}  // namespace penpose::render
