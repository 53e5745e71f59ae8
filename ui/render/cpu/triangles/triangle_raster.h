#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "ui/render/cpu/triangles/screen_vertices.h"

namespace penpose::render {

/// Px from left and top up to, but without, right and bottom.
struct PxRect {
  int left = 0, top = 0, right = 0, bottom = 0;
  [[nodiscard]] bool empty() const { return left >= right || top >= bottom; }
};
[[nodiscard]] inline PxRect shared_part(const PxRect& a, const PxRect& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

using Corners = std::array<Corner, 3>;

/// The px whose middles may lie in a triangle.
[[nodiscard]] inline PxRect px_around(const Corners& c) {
  const std::int32_t x0 = std::min(std::min(c[0].x, c[1].x), c[2].x);
  const std::int32_t x1 = std::max(std::max(c[0].x, c[1].x), c[2].x);
  const std::int32_t y0 = std::min(std::min(c[0].y, c[1].y), c[2].y);
  const std::int32_t y1 = std::max(std::max(c[0].y, c[1].y), c[2].y);
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
  float at_origin = 0, by_x = 0, by_y = 0, origin_x = 0, origin_y = 0;
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

/// The edges of a triangle over a rectangle of px: a px is inside where all three are zero or more.
template <typename Whole>
struct Edges {
  std::array<Whole, 3> row{};  ///< at the first px of the row
  std::array<Whole, 3> by_x{};
  std::array<Whole, 3> by_y{};

  Edges(const Corners& c, const PxRect& part) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner& p = c[(k + 1) % 3];
      const Corner& q = c[(k + 2) % 3];
      const Whole dx = q.x - p.x;
      const Whole dy = q.y - p.y;
      const Whole x = part.left * k_subpixels + k_subpixels / 2 - p.x;
      const Whole y = part.top * k_subpixels + k_subpixels / 2 - p.y;
      // Of an edge that two triangles share each px belongs to one of them: the one below it, or to its right.
      const Whole own = dy < 0 || (dy == 0 && dx > 0) ? 0 : -1;
      row[k] = dx * y - dy * x + own;
      by_x[k] = -dy * k_subpixels;
      by_y[k] = dx * k_subpixels;
    }
  }
  void next_row() {
    for (std::size_t k = 0; k < 3; ++k) row[k] += by_y[k];
  }
  /// Which px of a row of `width` are inside, from the first up to, but without, the second.
  [[nodiscard]] std::pair<int, int> inside(int width) const {
    Whole first = 0;
    Whole end = width;
    for (std::size_t k = 0; k < 3; ++k) {
      if (by_x[k] > 0) {
        if (row[k] < 0) first = std::max(first, (-row[k] + by_x[k] - 1) / by_x[k]);
      } else if (row[k] < 0) {
        return {0, 0};
      } else if (by_x[k] < 0) {
        end = std::min(end, row[k] / -by_x[k] + 1);
      }
    }
    return {static_cast<int>(first), static_cast<int>(end)};
  }
};

template <typename Whole, typename Visit>
void visit_px(const Corners& c, const PxRect& part, const Visit& visit) {
  Edges<Whole> edges(c, part);
  for (int y = part.top; y < part.bottom; ++y) {
    Whole a = edges.row[0];
    Whole b = edges.row[1];
    Whole d = edges.row[2];
    bool inside = false;
    for (int x = part.left; x < part.right; ++x) {
      if ((a | b | d) >= 0) {
        visit(x, y);
        inside = true;
      } else if (inside) {
        break;  // a row of a triangle has no gaps
      }
      a += edges.by_x[0];
      b += edges.by_x[1];
      d += edges.by_x[2];
    }
    edges.next_row();
  }
}

template <typename Whole, typename Visit>
void visit_rows(const Corners& c, const PxRect& part, const Visit& visit) {
  Edges<Whole> edges(c, part);
  for (int y = part.top; y < part.bottom; ++y) {
    const auto [first, end] = edges.inside(part.right - part.left);
    if (first < end) visit(part.left + first, part.left + end, y);
    edges.next_row();
  }
}

/// Sides of up to 64 px keep all products within 31 bits.
[[nodiscard]] inline bool is_small(const PxRect& around) {
  constexpr int k_small = 64;
  return around.right - around.left < k_small && around.bottom - around.top < k_small;
}

}  // namespace internal

/// Calls `visit(left, right, y)` for the px of each row of a rectangle whose middles lie in the triangle. Precondition:
/// an area above zero.
template <typename Visit>
void visit_rows(const Corners& c, const PxRect& within, const Visit& visit) {
  const PxRect around = px_around(c);
  const PxRect part = shared_part(around, within);
  if (part.empty()) return;
  if (internal::is_small(around)) {
    internal::visit_rows<std::int32_t>(c, part, visit);
  } else {
    internal::visit_rows<std::int64_t>(c, part, visit);
  }
}

/// Calls `visit(x, y)` for each px of a rectangle whose middle lies in the triangle, row by row. Precondition: an area
/// above zero.
template <typename Visit>
void visit_inside(const Corners& c, const PxRect& within, const Visit& visit) {
  const PxRect around = px_around(c);
  const PxRect part = shared_part(around, within);
  if (part.empty()) return;
  // In wide rows it is cheaper to divide for where they begin and end than to look at each px.
  constexpr int k_wide = 24;
  if (part.right - part.left > k_wide) {
    visit_rows(c, within, [&](int left, int right, int y) {
      for (int x = left; x < right; ++x) visit(x, y);
    });
  } else if (internal::is_small(around)) {
    internal::visit_px<std::int32_t>(c, part, visit);
  } else {
    internal::visit_px<std::int64_t>(c, part, visit);
  }
}

}  // namespace penpose::render
