#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "ui/render/cpu/triangles/screen_vertices.h"

namespace penpose::render {

/// Px from left and top up to, but without, right and bottom.
struct PxRect {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  [[nodiscard]] bool empty() const { return left >= right || top >= bottom; }
};
[[nodiscard]] inline PxRect shared_part(const PxRect& a, const PxRect& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

using Corners = std::array<Corner, 3>;

/// The px whose middles may lie in a triangle.
[[nodiscard]] inline PxRect px_around(const Corners& c) {
  const auto [x0, x1] = std::minmax({c[0].x, c[1].x, c[2].x});
  const auto [y0, y1] = std::minmax({c[0].y, c[1].y, c[2].y});
  // Middles lie at half a px; shifts of negative numbers round down.
  constexpr int k_half = k_subpixels / 2;
  return {(x0 + k_half - 1) >> 8, (y0 + k_half - 1) >> 8, ((x1 - k_half) >> 8) + 1, ((y1 - k_half) >> 8) + 1};
}

/// Twice the area in steps; above zero where the corners run with the clock on the screen.
[[nodiscard]] inline std::int64_t twice_area(const Corners& c) {
  return static_cast<std::int64_t>(c[1].x - c[0].x) * (c[2].y - c[0].y) -
         static_cast<std::int64_t>(c[1].y - c[0].y) * (c[2].x - c[0].x);
}

/// A plane over the picture that has given values at the corners.
struct PxPlane {
  float at_origin = 0;
  float by_x = 0;
  float by_y = 0;
  float origin_x = 0;
  float origin_y = 0;
  [[nodiscard]] float at(int x, int y) const {
    return at_origin + by_x * (static_cast<float>(x) - origin_x) + by_y * (static_cast<float>(y) - origin_y);
  }
};
/// Of the inverse depth at middles of px. Precondition: an area above zero.
[[nodiscard]] inline PxPlane depth_plane(const Corners& c, std::int64_t area) {
  constexpr float k_step = 1.0F / k_subpixels;
  const float x1 = static_cast<float>(c[1].x - c[0].x) * k_step;
  const float y1 = static_cast<float>(c[1].y - c[0].y) * k_step;
  const float x2 = static_cast<float>(c[2].x - c[0].x) * k_step;
  const float y2 = static_cast<float>(c[2].y - c[0].y) * k_step;
  const float over = 1.0F / (static_cast<float>(area) * (k_step * k_step));
  const float d1 = c[1].inverse_depth - c[0].inverse_depth;
  const float d2 = c[2].inverse_depth - c[0].inverse_depth;
  return {c[0].inverse_depth, (d1 * y2 - d2 * y1) * over, (d2 * x1 - d1 * x2) * over,
          static_cast<float>(c[0].x) * k_step - 0.5F, static_cast<float>(c[0].y) * k_step - 0.5F};
}

namespace internal {

template <typename Whole, typename Visit>
void visit_inside(const Corners& c, const PxRect& part, const Visit& visit) {
  std::array<Whole, 3> row{};
  std::array<Whole, 3> by_x{};
  std::array<Whole, 3> by_y{};
  for (int k = 0; k < 3; ++k) {
    const Corner& p = c[static_cast<std::size_t>((k + 1) % 3)];
    const Corner& q = c[static_cast<std::size_t>((k + 2) % 3)];
    const Whole dx = q.x - p.x;
    const Whole dy = q.y - p.y;
    const Whole x = part.left * k_subpixels + k_subpixels / 2 - p.x;
    const Whole y = part.top * k_subpixels + k_subpixels / 2 - p.y;
    // Of an edge that two triangles share each px belongs to one of them: the one below it, or to its right.
    const Whole own = dy < 0 || (dy == 0 && dx > 0) ? 0 : -1;
    const auto at = static_cast<std::size_t>(k);
    row[at] = dx * y - dy * x + own;
    by_x[at] = -dy * k_subpixels;
    by_y[at] = dx * k_subpixels;
  }
  for (int y = part.top; y < part.bottom; ++y) {
    Whole a = row[0];
    Whole b = row[1];
    Whole d = row[2];
    bool inside = false;
    for (int x = part.left; x < part.right; ++x) {
      if ((a | b | d) >= 0) {
        visit(x, y);
        inside = true;
      } else if (inside) {
        break;  // a row of a triangle has no gaps
      }
      a += by_x[0];
      b += by_x[1];
      d += by_x[2];
    }
    row[0] += by_y[0];
    row[1] += by_y[1];
    row[2] += by_y[2];
  }
}

}  // namespace internal

/// Calls `visit(x, y)` for each px of a rectangle whose middle lies in the triangle, row by row. Precondition: an area
/// above zero.
template <typename Visit>
void visit_inside(const Corners& c, const PxRect& within, const Visit& visit) {
  const PxRect around = px_around(c);
  const PxRect part = shared_part(around, within);
  if (part.empty()) return;
  // Sides of up to 64 px keep all products within 31 bits.
  constexpr int k_small = 64;
  if (around.right - around.left < k_small && around.bottom - around.top < k_small) {
    internal::visit_inside<std::int32_t>(c, part, visit);
  } else {
    internal::visit_inside<std::int64_t>(c, part, visit);
  }
}

}  // namespace penpose::render
