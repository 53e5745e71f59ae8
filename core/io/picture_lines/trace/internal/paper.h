#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/io/picture_lines/trace/trace_lines.h"

namespace penpose::io {

/// Paper less px, in each channel, -255..255.
struct PaperDifference {
  std::array<std::int16_t, 3> channels{};

  /// The largest of them without its sign.
  [[nodiscard]] int size() const {
    const auto without_sign = [](int v) { return v < 0 ? -v : v; };
    return std::max({without_sign(channels[0]), without_sign(channels[1]), without_sign(channels[2])});
  }
};

/// The paper of a drawing: a surface through the medians of tiles, each the median of those around it, so that what is
/// drawn does not count where it covers less than half of them.
class Paper {
 public:
  explicit Paper(const PictureView& picture);

  /// How far the px of a row are from their paper. Precondition: as many as the picture is wide.
  void compare(int y, std::span<std::uint8_t> sizes) const;
  [[nodiscard]] PaperDifference difference(int x, int y) const;

 private:
  [[nodiscard]] const std::uint8_t* px(int x, int y) const;
  void take_medians();
  void take_medians_around();

  PictureView picture_;
  int tile_;
  int columns_;
  int rows_;
  std::vector<std::array<std::uint8_t, 3>> tiles_;
};

}  // namespace penpose::io
