#include "core/io/picture_lines/trace/internal/ink.h"

#include <algorithm>
#include <array>

#include "core/io/picture_lines/trace/internal/hues.h"
#include "core/io/picture_lines/trace/internal/paper.h"

namespace penpose::io {
namespace {

constexpr int k_least_difference = 16;  ///< of 255, that can be seen

using Histogram = std::array<std::size_t, 256>;

/// The value below which a share (0..1) of a histogram lies.
int quantile(const Histogram& counts, double share) {
  std::size_t total = 0;
  for (const std::size_t one : counts) total += one;
  const double wanted = static_cast<double>(total) * share;
  std::size_t below = 0;
  for (int value = 0; value < 255; ++value) {
    below += counts[static_cast<std::size_t>(value)];
    if (static_cast<double>(below) >= wanted) return value;
  }
  return 255;
}

/// From which difference on a px is ink.
int threshold_of(const Histogram& counts) {
  // Half of all px are paper at the least, and what they differ by is noise.
  const int noise = std::max(k_least_difference, 4 * quantile(counts, 0.5));
  double sum = 0;
  double count = 0;
  for (std::size_t value = static_cast<std::size_t>(std::min(noise, 255)); value < 256; ++value) {
    sum += static_cast<double>(value * counts[value]);
    count += static_cast<double>(counts[value]);
  }
  return count > 0 ? std::max(noise, static_cast<int>(sum / count / 4)) : 256;
}

}  // namespace

Bitmap weights_of(const Ink& ink, int hue) {
  Bitmap weights(ink.hue.width(), ink.hue.height());
  const int noise = ink.threshold / 2;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const bool own = ink.hue[i] == 0 || ink.hue[i] == hue;
    if (own && ink.strength[i] > noise) weights[i] = static_cast<std::uint8_t>(ink.strength[i] - noise);
  }
  return weights;
}

Ink find_ink(const PictureView& picture) {
  Ink ink{Bitmap(picture.width, picture.height), Bitmap(picture.width, picture.height), 0, 0, 0};
  const Paper paper(picture);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(picture.width));
  Histogram counts{};
  for (int y = 0; y < picture.height; ++y) {
    paper.compare(y, row);
    const std::size_t begin = ink.strength.index(0, y);
    for (std::size_t x = 0; x < row.size(); ++x) {
      ink.strength[begin + x] = row[x];
      ++counts[row[x]];
    }
  }
  ink.threshold = threshold_of(counts);
  std::vector<InkPixel> pixels;
  const std::size_t most = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) / 2;
  for (std::size_t value = static_cast<std::size_t>(ink.threshold); value < 256; ++value) ink.covered += counts[value];
  if (ink.covered == 0 || ink.covered > most) return ink;
  pixels.reserve(ink.covered);
  for (int y = 0; y < picture.height; ++y) {
    const std::size_t begin = ink.strength.index(0, y);
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t at = begin + static_cast<std::size_t>(x);
      if (ink.strength[at] >= ink.threshold) {
        pixels.push_back({static_cast<std::uint32_t>(at), paper.difference(x, y)});
      }
    }
  }
  ink.hues = sort_by_hue(pixels, 2 * ink.threshold, ink.hue);
  return ink;
}

}  // namespace penpose::io
