#include "core/head/cage.h"

#include <algorithm>
#include <cmath>

namespace penpose::head {
namespace {

constexpr int k_columns = 13;
/// Columns in front stand at a given x, those behind them at an angle.
constexpr int k_first_angle_column = 7;

/// The vertices of the face grid; holes hold k_none.
constexpr std::uint32_t k_none = 0xffffffffU;
using Grid = std::array<std::array<std::uint32_t, k_columns>, k_rows>;

struct Hole {
  int top, bottom, left, right;
  [[nodiscard]] bool holds_quad(int r, int c) const { return r >= top && r < bottom && c >= left && c < right; }
  [[nodiscard]] bool holds_vertex(int r, int c) const { return r > top && r < bottom && c > left && c < right; }
};
constexpr Hole k_eye_hole{3, 5, 2, 6};
constexpr Hole k_nostril_hole{7, 8, 1, 2};
constexpr Hole k_ear_hole{4, 7, 8, 9};
/// One column further to the left, because its left border is the mirror plane.
constexpr Hole k_mouth_hole{8, 10, -1, 4};

constexpr std::array<std::array<double, k_first_angle_column>, k_rows> k_x{{
    {0, 1.15, 2.25, 3.3, 4.2, 4.95, 5.5},
    {0, 1.05, 2.1, 3.2, 4.3, 5.2, 5.95},
    {0, 0.8, 1.75, 2.8, 3.9, 4.95, 5.85},
    {0, 0.7, 1.5, 2.3, 3.4, 4.5, 5.4},
    {0, 0.62, 1.2, 2.3, 3.4, 4.5, 5.7},
    {0, 0.72, 1.55, 2.35, 3.4, 4.4, 5.3},
    {0, 0.72, 1.5, 2.3, 3.3, 4.3, 5.2},
    {0, 0.72, 1.55, 2.35, 3.3, 4.25, 5.1},
    {0, 0.75, 1.55, 2.45, 3.3, 4.15, 5.0},
    {0, 0.75, 1.55, 2.45, 3.75, 4.35, 5.0},
    {0, 0.7, 1.4, 2.2, 3.1, 3.95, 4.7},
    {0, 0.7, 1.4, 2.1, 2.85, 3.6, 4.3},
    {0, 0.7, 1.4, 2.1, 2.8, 3.4, 4.0},
    {0, 0.66, 1.32, 1.95, 2.5, 2.95, 3.3},
    {0, 0.6, 1.2, 1.75, 2.25, 2.65, 3.0},
    {0, 0.66, 1.32, 1.95, 2.5, 3.0, 3.4},
    {0, 0.85, 1.7, 2.5, 3.28, 4.0, 4.65},
    {0, 0.74, 1.48, 2.2, 2.88, 3.5, 4.07},
}};
constexpr std::array<double, k_columns - k_first_angle_column> k_degrees{65, 82, 104, 128, 154, 180};

/// Vertices that leave the level rows: brows, the borders of the holes, and the nose, which stands out by `lift`.
struct Placed {
  int r, c;
  double x, y;
  double lift = 0;
};
constexpr std::array<Placed, 41> k_placed{{
    {2, 1, 0.9, 3.05},       {2, 2, 1.6, 3.2},         {2, 3, 2.5, 3.4},
    {2, 4, 3.5, 3.5},        {2, 5, 4.55, 3.25},       {2, 6, 5.6, 2.6},
    {3, 1, 0.85, 2.4},       {3, 2, 1.5, 2.5},         {3, 3, 2.4, 2.7},
    {3, 4, 3.4, 2.8},        {3, 5, 4.4, 2.55},        {3, 6, 5.4, 1.85},
    {4, 0, 0, 0, 0.8},       {4, 1, 0.55, 0, 0.5},     {4, 2, 1, -0.2},
    {4, 6, 5.6, -0.1},       {5, 0, 0, -2, 1.9},       {5, 1, 0.6, -2, 1.6},
    {5, 2, 1.4, -2.1, 0.1},  {5, 3, 2.3, -2.4},        {5, 4, 3.3, -2.55},
    {5, 5, 4.3, -2.25},      {5, 6, 5.15, -1.65},      {6, 0, 0, -3.2, 2.9},
    {6, 1, 0.8, -3.25, 2.3}, {6, 2, 1.66, -3.6, 1.35}, {6, 3, 1.92, -3.45, -0.35},
    {7, 0, 0, -4.2, 1.9},    {7, 1, 0.36, -4.0, 1.7},  {7, 2, 1.62, -4.05, 1.0},
    {7, 3, 2.0, -4.3, -0.3}, {8, 0, 0, -4.7, 0.55},    {8, 1, 0.5, -4.55, 0.5},
    {8, 2, 1.5, -4.5, 0.2},  {8, 3, 2.3, -4.85},       {8, 4, 3.3, -5.3},
    {9, 4, 3.7, -6.5},       {10, 1, 0.75, -8.3},      {10, 2, 1.5, -8.2},
    {10, 3, 2.25, -8},       {10, 4, 3.05, -7.6},
}};

ModelPoint grid_point(int r, int c) {
  for (const Placed& p : k_placed) {
    if (p.r == r && p.c == c) return {p.x, p.y, bare_depth(p.x, p.y) + p.lift};
  }
  if (c < k_first_angle_column) {
    return point_at_x(row(r), k_x[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)]);
  }
  ModelPoint p = point_at_angle(row(r), k_degrees[static_cast<std::size_t>(c - k_first_angle_column)]);
  if (c == k_columns - 1) p.x = 0;
  return p;
}

std::uint32_t at(const Grid& grid, int r, int c) {
  return grid[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
}

QuadKind kind_of(int r, int c) {
  if (r == 2 && c >= 1 && c <= 5) return QuadKind::brow;
  // Under the hair, and below.
  const bool hidden = c >= 7 || (c >= 6 && r > 2) || (c >= 5 && r > 7) || r < 1 || r > 14;
  return hidden ? QuadKind::coarse_skin : QuadKind::skin;
}

Grid add_grid(Cage& cage) {
  Grid grid{};
  for (int r = 0; r < k_rows; ++r) {
    for (int c = 0; c < k_columns; ++c) {
      const bool hole =
          k_eye_hole.holds_vertex(r, c) || k_ear_hole.holds_vertex(r, c) || k_mouth_hole.holds_vertex(r, c);
      grid[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = hole ? k_none : cage.add(grid_point(r, c));
    }
  }
  for (int r = 0; r + 1 < k_rows; ++r) {
    for (int c = 0; c + 1 < k_columns; ++c) {
      if (k_eye_hole.holds_quad(r, c) || k_ear_hole.holds_quad(r, c) || k_mouth_hole.holds_quad(r, c) ||
          k_nostril_hole.holds_quad(r, c)) {
        continue;
      }
      cage.add_quad(at(grid, r + 1, c), at(grid, r + 1, c + 1), at(grid, r, c + 1), at(grid, r, c), kind_of(r, c));
    }
  }
  return grid;
}

/// A nostril: two loops inside a quad under the nose, and a floor.
void add_nostril(Cage& cage, const Grid& grid) {
  std::vector<std::uint32_t> outer{at(grid, 8, 1), at(grid, 8, 2), at(grid, 7, 2), at(grid, 7, 1)};
  const std::vector<std::uint32_t> border = outer;
  ModelPoint middle{0};
  for (const std::uint32_t v : border) middle += cage.points[v] * 0.25;
  struct Inset {
    double scale;
    ModelVector move;
  };
  constexpr std::array<Inset, 2> k_insets{{{0.78, {-0.03, 0.08, 0}}, {0.6, {-0.02, 1.1, 0}}}};
  for (const Inset& inset : k_insets) {
    std::vector<std::uint32_t> inner;
    for (const std::uint32_t v : border) {
      inner.push_back(cage.add(middle + (cage.points[v] - middle) * inset.scale + inset.move));
    }
    cage.add_strip(outer, inner, true, outer == border ? QuadKind::skin : QuadKind::lining);
    outer = inner;
  }
  cage.add_quad(outer[0], outer[1], outer[2], outer[3], QuadKind::lining);
}

/// The top of the skull: a patch of 3 x 6 quads whose three outer sides are the uppermost row.
void add_crown(Cage& cage, const Grid& grid) {
  constexpr int k_out = 3;
  constexpr int k_back = 6;
  constexpr double k_middle = 3.8;  // of the ellipsoid that the skull follows
  constexpr double k_height = 8.6;
  std::array<std::array<std::uint32_t, k_back + 1>, k_out + 1> patch{};
  for (int i = 0; i <= k_out; ++i) {
    for (int j = 0; j <= k_back; ++j) {
      std::uint32_t& slot = patch[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      if (j == 0) {
        slot = at(grid, 0, i);
      } else if (i == k_out) {
        slot = at(grid, 0, k_out + j);
      } else if (j == k_back) {
        slot = at(grid, 0, k_columns - 1 - i);
      } else {
        const double s = static_cast<double>(i) / k_out;
        const double t = static_cast<double>(j) / k_back;
        const ModelPoint front = cage.points[at(grid, 0, i)];
        const ModelPoint back = cage.points[at(grid, 0, k_columns - 1 - i)];
        const ModelPoint side = cage.points[at(grid, 0, k_out + j)];
        ModelPoint p = front + (back - front) * t;
        const double edge =
            cage.points[at(grid, 0, k_out)].x * (1 - t) + cage.points[at(grid, 0, k_out + k_back)].x * t;
        p.x = s * (edge + (side.x - edge) * (i == 0 ? 0.0 : 1.0));
        const double across = p.x / 8.0;
        const double along = (p.z + 0.9) / (p.z > -0.9 ? 9.2 : 8.8);
        p.y = k_middle + k_height * std::sqrt(std::max(1 - across * across - along * along, 0.0));
        slot = cage.add(p);
      }
    }
  }
  for (std::size_t i = 0; i < k_out; ++i) {
    for (std::size_t j = 0; j < k_back; ++j) {
      cage.add_quad(patch[i][j], patch[i + 1][j], patch[i + 1][j + 1], patch[i][j + 1], QuadKind::coarse_skin);
    }
  }
}

}  // namespace

std::uint32_t Cage::add(const ModelPoint& point, const LoopMark& mark) {
  points.push_back(point);
  marks.push_back(mark);
  return static_cast<std::uint32_t>(points.size() - 1);
}

void Cage::add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, QuadKind kind) {
  quads.push_back({a, b, c, d});
  kinds.push_back(kind);
}

void Cage::add_strip(const std::vector<std::uint32_t>& outer, const std::vector<std::uint32_t>& inner, bool closed,
                     QuadKind kind) {
  const std::size_t n = outer.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const std::size_t next = (i + 1) % n;
    add_quad(outer[i], outer[next], inner[next], inner[i], kind);
  }
}

Cage make_cage() {
  Cage cage;
  const Grid grid = add_grid(cage);
  add_crown(cage, grid);
  add_nostril(cage, grid);
  add_eye(cage, {at(grid, 4, 6), at(grid, 3, 6), at(grid, 3, 5), at(grid, 3, 4), at(grid, 3, 3), at(grid, 3, 2),
                 at(grid, 4, 2), at(grid, 5, 2), at(grid, 5, 3), at(grid, 5, 4), at(grid, 5, 5), at(grid, 5, 6)});
  add_mouth(cage, {at(grid, 10, 0), at(grid, 10, 1), at(grid, 10, 2), at(grid, 10, 3), at(grid, 10, 4), at(grid, 9, 4),
                   at(grid, 8, 4), at(grid, 8, 3), at(grid, 8, 2), at(grid, 8, 1), at(grid, 8, 0)});
  add_ear(cage, {at(grid, 4, 8), at(grid, 5, 8), at(grid, 6, 8), at(grid, 7, 8), at(grid, 7, 9), at(grid, 6, 9),
                 at(grid, 5, 9), at(grid, 4, 9)});
  return cage;
}

}  // namespace penpose::head
