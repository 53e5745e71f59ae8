#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/space.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::portrait {

/// A surface seen from the front of its face along parallel rays: which triangle is nearest at each px, and how deep.
/// Positions are in the face's frame; both sides of triangles are seen.
class FaceImage {
 public:
  static constexpr std::uint32_t k_nothing = 0xffffffffU;

  /// `box`: what is shown, model units; `px`: size of a px, > 0.
  FaceImage(const geometry::Box& box, double px);

  /// Draws triangles over what is there. `places`: of all vertices, in the frame.
  void draw(std::span<const geometry::ModelPoint> places, std::span<const mesh::Triangle> triangles,
            std::span<const std::uint32_t> which);

  /// An empty picture of a part, from px x0, y0 to before x1, y1, cut at the border.
  [[nodiscard]] FaceImage part(int x0, int y0, int x1, int y1) const;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] double px() const { return px_; }
  [[nodiscard]] bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  /// Precondition: inside.
  [[nodiscard]] std::uint32_t triangle(int x, int y) const { return triangles_[at(x, y)]; }
  [[nodiscard]] double depth(int x, int y) const { return depths_[at(x, y)]; }  ///< z; -1e300 where nothing is
  /// Middle of a px; its z is 0. y grows upwards.
  [[nodiscard]] geometry::ModelPoint place(double x, double y) const;
  [[nodiscard]] double column(double x) const { return (x - left_) / px_ - 0.5; }
  [[nodiscard]] double row(double y) const { return (y - bottom_) / px_ - 0.5; }

 private:
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  double left_ = 0, bottom_ = 0, px_ = 1;
  int width_ = 1, height_ = 1;
  std::vector<std::uint32_t> triangles_;
  std::vector<double> depths_;
};

/// Barycentric coordinates in the picture of a triangle's corners, at a place; those of the first corner for a triangle
/// without area there.
[[nodiscard]] std::array<double, 3> seen_barycentric(const geometry::ModelPoint& place, const geometry::ModelPoint& a,
                                                     const geometry::ModelPoint& b, const geometry::ModelPoint& c);

}  // namespace penpose::portrait
