#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ui/render/cpu/shading/texture_map.h"
#include "ui/render/cpu/triangles/clipped_pieces.h"
#include "ui/render/cpu/triangles/screen_vertices.h"
#include "ui/render/draw_list.h"

namespace penpose::render {

/// Triangles that are drawn in one way, one after the other. Their items count on from `first_item`.
struct Segment {
  std::uint32_t first_item = 0;
  std::span<const mesh::Triangle> triangles;
  const document::Surface* surface = nullptr;  ///< of a look; null: a plain surface
  const TextureMap* texture = nullptr;         ///< null: none, or it could not be unpacked
  TextureTransform place;
  const TextureMap* shade_texture = nullptr;  ///< of the second tone
  TextureTransform shade_place;
  float roughness = 0;
  float metallic = 0;
  float least_alpha = -1;    ///< what is fainter is left out; below zero: nothing is
  bool culls_back = false;   ///< what is seen from its back is left out
  bool outline = false;      ///< the line around a surface: what is seen from its front is left out
  std::uint32_t shift = 0;   ///< from a vertex to the place of its corner among those that were placed
  bool see_through = false;  ///< blended over what is behind it
};

/// The corners of a triangle of a segment.
[[nodiscard]] inline Corners corners_of(const Segment& segment, const mesh::Triangle& t,
                                        std::span<const ScreenVertex> vertices) {
  return {vertices[t[0] + segment.shift].corner, vertices[t[1] + segment.shift].corner,
          vertices[t[2] + segment.shift].corner};
}

/// What is drawn in each tile of a picture, in the order in which it is drawn.
class DrawItems {
 public:
  static constexpr int k_tile_width = 64;
  static constexpr int k_tile_height = 32;
  /// In place of an item: the piece of a clipped triangle of that number.
  static constexpr std::uint32_t k_piece = std::uint32_t{1} << 31U;

  /// Spans must outlive it; vertices are those that the raster has placed. Items of segments count from 0 without gaps.
  /// Tiles that are not `wanted` get none; empty: all are wanted.
  void sort(const Raster& raster, std::span<const glm::vec3> positions, std::span<const ScreenVertex> vertices,
            std::vector<Segment> segments, const std::vector<bool>& wanted);

  [[nodiscard]] int tile_count() const { return columns_ * rows_; }
  [[nodiscard]] PxRect tile(int index) const;
  [[nodiscard]] std::span<const std::uint32_t> items(int tile) const {
    return std::span(items_).subspan(
        starts_[static_cast<std::size_t>(tile)],
        starts_[static_cast<std::size_t>(tile) + 1] - starts_[static_cast<std::size_t>(tile)]);
  }
  [[nodiscard]] const Piece& piece(std::uint32_t item) const { return pieces_[item & ~k_piece]; }
  /// The segment that has an item.
  [[nodiscard]] const Segment& segment_of(std::uint32_t item) const;

 private:
  int columns_ = 0;
  int rows_ = 0;
  geometry::Viewport size_;
  std::vector<Segment> segments_;
  std::vector<Piece> pieces_;
  struct InTile {
    std::uint32_t tile = 0;
    std::uint32_t item = 0;
  };
  std::vector<InTile> in_tiles_;  ///< in the order in which they are drawn
  std::vector<std::uint32_t> items_;
  std::vector<std::uint32_t> starts_;  ///< of each tile in items_, and the end
};

/// The tiles that some px of a picture lie in, as columns and rows. Precondition: there are some.
[[nodiscard]] inline PxRect tiles_of(const PxRect& px) {
  // Sides are powers of two, and no place is below zero.
  constexpr unsigned k_width = DrawItems::k_tile_width;
  constexpr unsigned k_height = DrawItems::k_tile_height;
  const auto in = [](int at, unsigned side) { return static_cast<int>(static_cast<unsigned>(at) / side); };
  return {in(px.left, k_width), in(px.top, k_height), in(px.right - 1, k_width) + 1, in(px.bottom - 1, k_height) + 1};
}

}  // namespace penpose::render
