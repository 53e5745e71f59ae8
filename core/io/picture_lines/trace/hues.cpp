#include "core/io/picture_lines/trace/internal/hues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace penpose::io {
namespace {

using Direction = std::array<double, 3>;

constexpr double k_same_hue = 0.978;  ///< cosine of 12 degrees
constexpr std::size_t k_most_hues = 8;
constexpr double k_least_share = 0.003;  ///< of the ink
constexpr std::size_t k_least_px = 30;
constexpr int k_levels = 9;  ///< of each channel of a direction, in which hues are counted

double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Direction unit(const Direction& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 ? Direction{v[0] / size, v[1] / size, v[2] / size} : v;
}

Direction direction_of(const PaperDifference& difference) {
  const auto& c = difference.channels;
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
}

/// Px of nearly the same hue.
struct Crowd {
  Direction sum{};
  std::size_t count = 0;
};

std::vector<Crowd> crowds_of(std::span<const InkPixel> pixels, int strong) {
  std::vector<Crowd> crowds(k_levels * k_levels * k_levels);
  for (const InkPixel& one : pixels) {
    const int size = one.difference.size();
    if (size < strong) continue;
    std::size_t place = 0;
    for (const int c : one.difference.channels) {
      const int level = (c * (k_levels - 1) + (c < 0 ? -size : size)) / (2 * size) + k_levels / 2;
      place = place * k_levels + static_cast<std::size_t>(std::clamp(level, 0, k_levels - 1));
    }
    const Direction direction = unit(direction_of(one.difference));
    for (std::size_t c = 0; c < 3; ++c) crowds[place].sum[c] += direction[c];
    ++crowds[place].count;
  }
  return crowds;
}

/// The hues with the most px, each apart from the others.
std::vector<Direction> hues_of(std::vector<Crowd> crowds) {
  std::size_t total = 0;
  for (const Crowd& one : crowds) total += one.count;
  const std::size_t least = std::max(k_least_px, static_cast<std::size_t>(static_cast<double>(total) * k_least_share));
  std::stable_sort(crowds.begin(), crowds.end(), [](const Crowd& a, const Crowd& b) { return a.count > b.count; });
  std::vector<Direction> hues;
  for (const Crowd& one : crowds) {
    if (one.count < least || hues.size() == k_most_hues) break;
    const Direction direction = unit(one.sum);
    if (std::none_of(hues.begin(), hues.end(),
                     [&](const Direction& hue) { return dot(hue, direction) > k_same_hue; })) {
      hues.push_back(direction);
    }
  }
  return hues;
}

std::uint8_t nearest_of(const std::vector<Direction>& hues, const Direction& direction) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < hues.size(); ++i) {
    if (dot(hues[i], direction) > dot(hues[best], direction)) best = i;
  }
  return static_cast<std::uint8_t>(best + 1);
}

void assign(std::span<const InkPixel> pixels, const std::vector<Direction>& hues, Bitmap& hue) {
  for (const InkPixel& one : pixels) hue[one.index] = nearest_of(hues, direction_of(one.difference));
}

/// The hue whose px for the most part lie beside px of others: the coloured edge of lines, as lenses and sampled
/// colours make it. Nothing (hues.size()) where there is none.
std::size_t fringe_of(std::span<const InkPixel> pixels, std::size_t hues, const Bitmap& hue) {
  std::vector<std::size_t> counts(hues);
  std::vector<std::size_t> beside(hues);
  const std::size_t down = hue.stride();
  for (const InkPixel& one : pixels) {
    const std::uint8_t own = hue[one.index];
    int others = 0;
    const std::size_t at = one.index;
    for (const std::size_t place :
         {at - down - 1, at - down, at - down + 1, at - 1, at + 1, at + down - 1, at + down, at + down + 1}) {
      others += hue[place] != 0 && hue[place] != own;
    }
    ++counts[own - 1U];
    beside[own - 1U] += others >= 2;
  }
  for (std::size_t i = hues; i-- > 0;) {
    if (beside[i] * 2 > counts[i] || counts[i] < k_least_px) return i;
  }
  return hues;
}

}  // namespace

int sort_by_hue(std::span<const InkPixel> pixels, int strong, Bitmap& hue) {
  std::vector<Direction> hues = hues_of(crowds_of(pixels, strong));
  if (hues.empty()) hues.push_back({1, 1, 1});
  assign(pixels, hues, hue);
  while (hues.size() > 1) {
    const std::size_t fringe = fringe_of(pixels, hues.size(), hue);
    if (fringe == hues.size()) break;
    hues.erase(hues.begin() + static_cast<std::ptrdiff_t>(fringe));
    assign(pixels, hues, hue);
  }
  return static_cast<int>(hues.size());
}

}  // namespace penpose::io
