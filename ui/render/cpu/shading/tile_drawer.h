#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ui/render/behind.h"
#include "ui/render/cpu/shading/surface_points.h"
#include "ui/render/picture/image.h"

namespace penpose::render {

/// What all tiles of a picture are drawn from.
struct TileScene {
  const Raster& raster;
  std::span<const ScreenVertex> vertices;
  VertexPaint paint;
  const DrawItems& items;
  std::span<const std::pair<std::uint32_t, std::uint32_t>> edges;  ///< drawn over what is opaque
  const Image& backdrop;                                           ///< of the picture's size
  const Behind& behind;                                            ///< drawn last where it is before the model
  bool matcap = false;                                             ///< Scene::matcap
};

/// Draws surfaces, a tile at a time: which triangle is nearest at each px, then the light of those alone. Tiles need
/// nothing of each other, so that threads may draw them in any order.
class TileDrawer {
 public:
  explicit TileDrawer(const TileScene& scene);

  /// Writes px of the tile into the picture, which has the size of the raster, and inverse depths (0: nothing there)
  /// into `depths`, one a px of the picture, where it is not empty.
  void draw(int tile, Image& picture, std::span<float> depths);

 private:
  static constexpr int k_px = DrawItems::k_tile_width * DrawItems::k_tile_height;
  static constexpr int k_block_px = 8;  ///< a side of squares whose farthest depth is known
  static constexpr int k_block_columns = DrawItems::k_tile_width / k_block_px;
  static constexpr int k_block_rows = DrawItems::k_tile_height / k_block_px;
  static constexpr std::uint32_t k_nothing = ~std::uint32_t{0};

  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>((y - rect_.top) * DrawItems::k_tile_width + x - rect_.left);
  }
  void find_nearest(std::uint32_t item, const ScreenTriangle& triangle);
  /// Takes down how far each block is seen to.
  void measure_blocks();
  [[nodiscard]] bool is_hidden(const ScreenTriangle& triangle) const;
  void draw_backdrop(Image& picture) const;
  /// The picture that is before the model.
  void draw_front(Image& picture) const;
  void draw_nearest(Image& picture);
  void draw_edges(Image& picture);
  void draw_blended(std::uint32_t item, Image& picture);
  void finish_opaque(Image& picture);
  void finish_blended(Image& picture);
  void put(std::size_t fragment, Image& picture, float alpha) const;

  const TileScene& scene_;
  SurfacePoints points_;
  PxToEye eye_;
  PxRect rect_;
  std::array<float, k_px> depth_;            ///< inverse
  std::array<std::uint32_t, k_px> nearest_;  ///< item
  std::array<float, static_cast<std::size_t>(k_block_columns* k_block_rows)>
      farthest_;                       ///< inverse depth of each block
  std::vector<std::uint32_t> behind_;  ///< items seen from their back
  Fragments fragments_;
  std::array<std::uint16_t, Fragments::k_most> place_;  ///< of each fragment in the tile
  std::array<float, Fragments::k_most> alpha_;
};

}  // namespace penpose::render
