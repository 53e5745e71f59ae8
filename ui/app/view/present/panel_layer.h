#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ui/render/picture/image.h"

struct ImDrawData;

namespace penpose::app {

/// ImGui's panels as a layer over a picture, painted by the processor. What looks as it did in the frame before is not
/// painted again: tiles of the layer are kept by a hash of all that is drawn in them.
class PanelLayer {
 public:
  /// Lays panels over a picture, whose size they have. Reads the picture of the letters where ImGui has it, which must
  /// not change meanwhile.
  void lay(const ImDrawData& panels, render::Image& picture);
  /// The letters have changed: all is painted again.
  void forget() { tiles_.clear(); }
  /// Tiles that the last call painted.
  [[nodiscard]] std::size_t painted() const { return painted_; }

  static constexpr int k_tile_width = 64;
  static constexpr int k_tile_height = 32;

 private:
  struct Tile {
    std::uint64_t hash = 0;  ///< of what is drawn in it
    bool dirty = false;
    std::vector<std::uint8_t> own;   ///< colours times their alpha, R G B A; empty: nothing is drawn
    std::vector<std::uint8_t> rest;  ///< how much of each byte below is seen; empty: none of it
  };

  void hash_tiles(const ImDrawData& panels);
  void paint_tiles(const ImDrawData& panels);
  void lay_tile(const Tile& tile, int column, int row, render::Image& picture) const;

  int width_ = 0;
  int height_ = 0;
  int columns_ = 0;
  std::vector<Tile> tiles_;
  std::vector<std::uint64_t> hashes_;
  std::size_t painted_ = 0;
};

}  // namespace penpose::app
