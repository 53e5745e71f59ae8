#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::io {

/// A picture of a byte a px, in a margin of zeros of one px, so that every px has eight neighbours. Sides are at most
/// 16384 px, so that places fit 32 bits.
class Bitmap {
 public:
  Bitmap(int width, int height)
      : width_(width),
        height_(height),
        stride_(static_cast<std::size_t>(width) + 2),
        cells_(stride_ * (static_cast<std::size_t>(height) + 2)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// How far below each other px are.
  [[nodiscard]] std::size_t stride() const { return stride_; }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>(y) + 1) * stride_ + static_cast<std::size_t>(x) + 1;
  }
  [[nodiscard]] int x_of(std::size_t index) const {
    return static_cast<int>(static_cast<std::uint32_t>(index) % static_cast<std::uint32_t>(stride_)) - 1;
  }
  [[nodiscard]] int y_of(std::size_t index) const {
    return static_cast<int>(static_cast<std::uint32_t>(index) / static_cast<std::uint32_t>(stride_)) - 1;
  }
  /// The middle of a px.
  [[nodiscard]] geometry::PxPoint middle(std::size_t index) const { return {x_of(index) + 0.5, y_of(index) + 0.5}; }
  [[nodiscard]] bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  [[nodiscard]] std::uint8_t& operator[](std::size_t i) { return cells_[i]; }
  [[nodiscard]] std::uint8_t operator[](std::size_t i) const { return cells_[i]; }

 private:
  int width_;
  int height_;
  std::size_t stride_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace penpose::io
