#include "core/portrait/surface/face_image.h"

#include <algorithm>
#include <cmath>

namespace penpose::portrait {
namespace {

using geometry::ModelPoint;

/// A picture has no more px than this along a side.
constexpr double k_most_px = 1024;

double area(const ModelPoint& a, const ModelPoint& b, const ModelPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int whole_px(double value) { return static_cast<int>(std::clamp(std::ceil(value), 1.0, k_most_px)); }

}  // namespace

FaceImage::FaceImage(const geometry::Box& box, double px)
    : left_(box.minimum.x),
      bottom_(box.minimum.y),
      px_(px),
      width_(whole_px((box.maximum.x - box.minimum.x) / px)),
      height_(whole_px((box.maximum.y - box.minimum.y) / px)),
      triangles_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), k_nothing),
      depths_(triangles_.size(), -1e300) {}

FaceImage FaceImage::part(int x0, int y0, int x1, int y1) const {
  FaceImage image({ModelPoint{0}, ModelPoint{px_}}, px_);
  const int x = std::clamp(x0, 0, width_ - 1);
  const int y = std::clamp(y0, 0, height_ - 1);
  image.left_ = left_ + x * px_;
  image.bottom_ = bottom_ + y * px_;
  image.width_ = std::clamp(x1 - x, 1, width_ - x);
  image.height_ = std::clamp(y1 - y, 1, height_ - y);
  image.triangles_.assign(static_cast<std::size_t>(image.width_) * image.height_, k_nothing);
  image.depths_.assign(image.triangles_.size(), -1e300);
  return image;
}

ModelPoint FaceImage::place(double x, double y) const {
  return {left_ + (x + 0.5) * px_, bottom_ + (y + 0.5) * px_, 0};
}

void FaceImage::draw(std::span<const ModelPoint> places, std::span<const mesh::Triangle> triangles,
                     std::span<const std::uint32_t> which) {
  for (const std::uint32_t number : which) {
    const ModelPoint& a = places[triangles[number][0]];
    const ModelPoint& b = places[triangles[number][1]];
    const ModelPoint& c = places[triangles[number][2]];
    const double whole = area(a, b, c);
    if (!(std::abs(whole) > 0.0)) continue;
    const auto [low_x, high_x] = std::minmax({a.x, b.x, c.x});
    const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
    const int from_x = static_cast<int>(std::max(0.0, std::ceil(column(low_x))));
    const int to_x = static_cast<int>(std::min(width_ - 1.0, std::floor(column(high_x))));
    const int from_y = static_cast<int>(std::max(0.0, std::ceil(row(low_y))));
    const int to_y = static_cast<int>(std::min(height_ - 1.0, std::floor(row(high_y))));
    for (int y = from_y; y <= to_y; ++y) {
      for (int x = from_x; x <= to_x; ++x) {
        const ModelPoint p = place(x, y);
        const double u = area(b, c, p) / whole;
        const double v = area(c, a, p) / whole;
        const double w = 1.0 - u - v;
        if (u < -1e-9 || v < -1e-9 || w < -1e-9) continue;
        const double z = u * a.z + v * b.z + w * c.z;
        if (z > depths_[at(x, y)]) {
          depths_[at(x, y)] = z;
          triangles_[at(x, y)] = number;
        }
      }
    }
  }
}

std::array<double, 3> seen_barycentric(const ModelPoint& place, const ModelPoint& a, const ModelPoint& b,
                                       const ModelPoint& c) {
  const double whole = area(a, b, c);
  if (!(std::abs(whole) > 0.0)) return {1, 0, 0};
  const double u = std::clamp(area(b, c, place) / whole, 0.0, 1.0);
  const double v = std::clamp(area(c, a, place) / whole, 0.0, 1.0 - u);
  return {u, v, 1.0 - u - v};
}

}  // namespace penpose::portrait
