#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/math.h"
#include "core/io/picture_lines/trace/trace_lines.h"

namespace penpose::tests {

using geometry::PxPoint;
using Color = std::array<double, 3>;
using Points = std::vector<PxPoint>;

inline constexpr Color k_black{0, 0, 0};
inline constexpr Color k_white{255, 255, 255};

/// The distance of a place from a polyline.
inline double distance_to(PxPoint p, std::span<const PxPoint> line) {
  double least = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double share = geometry::nearest_share(p, line[i - 1], line[i]);
    least = std::min(least, geometry::distance(p, line[i - 1] + (line[i] - line[i - 1]) * share));
  }
  return least;
}

/// Points of a curve, given by its parameter 0..1.
inline Points curve(const std::function<PxPoint(double)>& at, int count = 400) {
  Points points;
  for (int i = 0; i <= count; ++i) points.push_back(at(static_cast<double>(i) / count));
  return points;
}

/// Paper that lines are drawn on with a round brush, with soft edges as painting programs have them.
class DrawnPaper {
 public:
  DrawnPaper(int width, int height, Color paper = k_white)
      : width_(width),
        height_(height),
        colors_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), paper) {}

  DrawnPaper& draw(std::span<const PxPoint> line, double width, Color color = k_black) {
    std::vector<double> covered(colors_.size());
    for (std::size_t i = 1; i < line.size(); ++i) {
      const PxPoint a = line[i - 1];
      const PxPoint b = line[i];
      const double reach = width / 2 + 1;
      const int right = std::min(width_ - 1, static_cast<int>(std::max(a.x, b.x) + reach));
      const int bottom = std::min(height_ - 1, static_cast<int>(std::max(a.y, b.y) + reach));
      for (int y = std::max(0, static_cast<int>(std::min(a.y, b.y) - reach)); y <= bottom; ++y) {
        for (int x = std::max(0, static_cast<int>(std::min(a.x, b.x) - reach)); x <= right; ++x) {
          const PxPoint p{x + 0.5, y + 0.5};
          const double off = geometry::distance(p, a + (b - a) * geometry::nearest_share(p, a, b));
          double& cover = covered[place(x, y)];
          cover = std::max(cover, std::clamp(width / 2 + 0.5 - off, 0.0, std::min(1.0, width)));
        }
      }
    }
    for (std::size_t i = 0; i < colors_.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) colors_[i][c] += (color[c] - colors_[i][c]) * covered[i];
    }
    return *this;
  }

  /// Changes every px by its place: uneven light, grain.
  DrawnPaper& change(const std::function<void(int x, int y, Color& color)>& by) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) by(x, y, colors_[place(x, y)]);
    }
    return *this;
  }

  [[nodiscard]] std::vector<std::uint8_t> pixels() const {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(colors_.size() * 4);
    for (const Color& color : colors_) {
      for (const double c : color) bytes.push_back(static_cast<std::uint8_t>(std::clamp(c + 0.5, 0.0, 255.0)));
      bytes.push_back(255);
    }
    return bytes;
  }

  [[nodiscard]] base::Result<io::PictureLines> trace() const {
    const auto bytes = pixels();
    return io::trace_lines({width_, height_, bytes});
  }

 private:
  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  std::vector<Color> colors_;
};

/// How far a traced line is from the one that was drawn, and how much of that it missed at its ends.
struct Deviation {
  double mean = 0;
  double most = 0;
  double missed = 0;
};
inline Deviation deviation(std::span<const PxPoint> traced, std::span<const PxPoint> drawn) {
  Deviation all;
  double length = 0;
  for (std::size_t i = 1; i < traced.size(); ++i) {
    const double step = geometry::distance(traced[i - 1], traced[i]);
    const int pieces = static_cast<int>(step) + 1;
    for (int k = 0; k < pieces; ++k) {
      const double off = distance_to(traced[i - 1] + (traced[i] - traced[i - 1]) * ((k + 0.5) / pieces), drawn);
      all.mean += off * step / pieces;
      all.most = std::max(all.most, off);
    }
    length += step;
  }
  all.mean /= std::max(length, 1e-9);
  for (const PxPoint p : {drawn.front(), drawn.back()}) all.missed = std::max(all.missed, distance_to(p, traced));
  return all;
}

}  // namespace penpose::tests
