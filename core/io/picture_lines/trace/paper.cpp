#include "core/io/picture_lines/trace/internal/paper.h"

#include <cstdlib>
#include <utility>

namespace penpose::io {
namespace {

constexpr int k_tiles = 24;    ///< along the longer side
constexpr int k_around = 2;    ///< tiles on each side
constexpr int k_samples = 16;  ///< along each side of a tile

/// A channel on white.
int on_white(const std::uint8_t* px, std::size_t channel) {
  const int alpha = px[3];
  return alpha == 255 ? px[channel] : 255 - (255 - px[channel]) * alpha / 255;
}

/// A place between the middles of two tiles, in 1/256.
struct Between {
  int first = 0;
  int second = 0;
  int share = 0;
};

Between between(int at, int tile, int count) {
  const int shifted = std::max(0, 2 * at + 1 - tile);
  const int first = std::min(shifted / (2 * tile), count - 1);
  const int second = std::min(first + 1, count - 1);
  return {first, second, (shifted - first * 2 * tile) * 256 / (2 * tile)};
}

}  // namespace

Paper::Paper(const PictureView& picture)
    : picture_(picture),
      tile_(std::clamp(std::max(picture.width, picture.height) / k_tiles, 16, 256)),
      columns_((picture.width + tile_ - 1) / tile_),
      rows_((picture.height + tile_ - 1) / tile_) {
  take_medians();
  take_medians_around();
}

void Paper::take_medians() {
  tiles_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  const int step = std::max(1, tile_ / k_samples);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      std::array<std::array<std::uint32_t, 256>, 3> counts{};
      std::uint32_t total = 0;
      for (int y = row * tile_; y < std::min((row + 1) * tile_, picture_.height); y += step) {
        for (int x = column * tile_; x < std::min((column + 1) * tile_, picture_.width); x += step) {
          const std::uint8_t* at = px(x, y);
          for (std::size_t c = 0; c < 3; ++c) ++counts[c][static_cast<std::size_t>(on_white(at, c))];
          ++total;
        }
      }
      auto& tile =
          tiles_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
      for (std::size_t c = 0; c < 3; ++c) {
        std::uint32_t below = 0;
        std::size_t value = 0;
        while ((below += counts[c][value]) * 2 < total) ++value;
        tile[c] = static_cast<std::uint8_t>(value);
      }
    }
  }
}

void Paper::take_medians_around() {
  auto smooth = tiles_;
  std::vector<std::uint8_t> values;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      // As far on one side as on the other, so that light that falls off evenly stays as it is.
      const int left = std::min({k_around, column, columns_ - 1 - column});
      const int up = std::min({k_around, row, rows_ - 1 - row});
      // At the border that is no tile more; there the tiles along it count.
      const int across = left == 0 && up == 0 ? 1 : 0;
      for (std::size_t c = 0; c < 3; ++c) {
        values.clear();
        for (int r = std::max(0, row - std::max(up, across)); r <= std::min(rows_ - 1, row + std::max(up, across));
             ++r) {
          for (int k = std::max(0, column - std::max(left, across));
               k <= std::min(columns_ - 1, column + std::max(left, across)); ++k) {
            values.push_back(tiles_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                                    static_cast<std::size_t>(k)][c]);
          }
        }
        std::stable_sort(values.begin(), values.end());
        smooth[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)]
              [c] = values[values.size() / 2];
      }
    }
  }
  tiles_ = std::move(smooth);
}

const std::uint8_t* Paper::px(int x, int y) const {
  return &picture_.pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
                           static_cast<std::size_t>(x)) *
                          4];
}

PaperDifference Paper::difference(int x, int y) const {
  const Between across = between(x, tile_, columns_);
  const Between down = between(y, tile_, rows_);
  const auto tile = [&](int row, int column) -> const auto& {
    return tiles_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  };
  const std::uint8_t* at = px(x, y);
  PaperDifference difference;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto of_column = [&](int column) {
      return tile(down.first, column)[c] * (256 - down.share) + tile(down.second, column)[c] * down.share;
    };
    const int level = of_column(across.first) * (256 - across.share) + of_column(across.second) * across.share;
    difference.channels[c] = static_cast<std::int16_t>(((level + 32768) >> 16) - on_white(at, c));
  }
  return difference;
}

void Paper::compare(int y, std::span<std::uint8_t> sizes) const {
  const Between rows = between(y, tile_, rows_);
  const auto* first = &tiles_[static_cast<std::size_t>(rows.first) * static_cast<std::size_t>(columns_)];
  const auto* second = &tiles_[static_cast<std::size_t>(rows.second) * static_cast<std::size_t>(columns_)];
  const std::uint8_t* at = px(0, y);
  // The paper along the row, in 1/65536: a straight line between the middles of tiles.
  for (int begin = 0; begin < picture_.width;) {
    const Between columns = between(begin, tile_, columns_);
    std::array<int, 3> level{};
    std::array<int, 3> slope{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto of_column = [&](int column) {
        const auto k = static_cast<std::size_t>(column);
        return first[k][c] * (256 - rows.share) + second[k][c] * rows.share;
      };
      const int left = of_column(columns.first);
      const int right = of_column(columns.second);
      level[c] = left * 256 + (right - left) * columns.share + 32768;
      slope[c] = begin == 0 ? 0 : (right - left) * 256 / tile_;
    }
    const int end = std::min(picture_.width, begin == 0 ? tile_ / 2 : begin + tile_);
    for (int x = begin; x < end; ++x, at += 4) {
      int most = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        most = std::max(most, std::abs((level[c] >> 16) - on_white(at, c)));
        level[c] += slope[c];
      }
      sizes[static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(most);
    }
    begin = end;
  }
}

}  // namespace penpose::io
