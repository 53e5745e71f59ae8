#include <algorithm>
#include <cmath>

#include "core/head/cage.h"

namespace penpose::head {
namespace {

constexpr std::size_t k_count = 12;
struct Offset {
  double x, y;
};
using Loop = std::array<Offset, k_count>;

// Loops relative to the eye's centre as seen from the front, counter-clockwise from the outer corner; in eye radii.
constexpr Loop k_rim{{{0.880, 0.040},
                      {0.720, 0.280},
                      {0.430, 0.450},
                      {0.030, 0.510},
                      {-0.360, 0.450},
                      {-0.680, 0.220},
                      {-0.920, -0.170},
                      {-0.680, -0.330},
                      {-0.360, -0.430},
                      {0.010, -0.470},
                      {0.390, -0.410},
                      {0.710, -0.220}}};
constexpr Loop k_lid{{{0.980, 0.040},
                      {0.820, 0.420},
                      {0.490, 0.650},
                      {0.030, 0.720},
                      {-0.410, 0.620},
                      {-0.770, 0.340},
                      {-1.020, -0.180},
                      {-0.760, -0.430},
                      {-0.400, -0.560},
                      {0.010, -0.610},
                      {0.440, -0.540},
                      {0.810, -0.300}}};
constexpr Loop k_crease{{{1.170, 0.040},
                         {0.930, 0.640},
                         {0.540, 0.900},
                         {0.030, 0.980},
                         {-0.470, 0.860},
                         {-0.870, 0.500},
                         {-1.100, -0.190},
                         {-0.880, -0.620},
                         {-0.460, -0.820},
                         {0.000, -0.900},
                         {0.510, -0.810},
                         {0.970, -0.480}}};
constexpr std::array<double, k_count> k_crease_depth{0.30, 0.64, 0.80, 0.84, 0.86, 0.82,
                                                     0.74, 0.86, 0.92, 0.88, 0.72, 0.42};
constexpr double k_rim_thickness = 0.1;

ModelPoint center() { return {k_eye_center[0], k_eye_center[1], k_eye_center[2]}; }

/// The point of a sphere of `radius` eye radii that is seen at an offset.
ModelPoint on_sphere(const Offset& o, double radius) {
  return center() + ModelVector{o.x, o.y, std::sqrt(radius * radius - o.x * o.x - o.y * o.y)} * k_eye_radius;
}

}  // namespace

void add_eye(Cage& cage, const std::vector<std::uint32_t>& border) {
  for (const std::uint32_t v : border) cage.marks[v].x = 4;
  std::array<std::vector<std::uint32_t>, 6> loops;
  for (std::size_t i = 0; i < k_count; ++i) {
    const Offset& rim = k_rim[i];
    const Offset edge{rim.x * 1.035, rim.y * 1.05};
    const double around = std::sqrt(rim.x * rim.x + rim.y * rim.y);
    const ModelVector outward{rim.x / around, rim.y / around, 0};
    const double pocket = k_eye_radius * 1.1;
    const ModelVector crease{k_crease[i].x, k_crease[i].y, k_crease_depth[i]};
    loops[0].push_back(cage.add(center() + crease * k_eye_radius, {3, 5, 0}));
    loops[1].push_back(cage.add(on_sphere(k_lid[i], 1.13), {2, 5, 0}));
    loops[2].push_back(cage.add(on_sphere(edge, 1.03 + k_rim_thickness), {1, 5, 0}));
    loops[3].push_back(cage.add(on_sphere(rim, 1.02), {0, 5, 0}));
    loops[4].push_back(cage.add(center() + outward * (pocket * 0.98) + ModelVector{0, 0, pocket * 0.15}, {-1, 5, 0}));
    loops[5].push_back(cage.add(center() + outward * (pocket * 0.8) + ModelVector{0, 0, -pocket * 0.75}, {-2, 5, 0}));
  }
  cage.add_strip(border, loops[0], true);
  for (std::size_t i = 0; i + 1 < loops.size(); ++i) {
    const std::size_t first = cage.quads.size();
    cage.add_strip(loops[i], loops[i + 1], true, i >= 3 ? QuadKind::coarse_skin : QuadKind::skin);
    // The edge of the upper lid.
    if (i == 2) std::fill_n(cage.kinds.begin() + static_cast<std::ptrdiff_t>(first), k_count / 2, QuadKind::lash);
  }
  // The back of the socket: the last loop as a rectangle of 4 x 2 quads.
  const auto& last = loops.back();
  std::array<std::uint32_t, 3> middle{};
  for (std::size_t i = 0; i < 3; ++i) {
    middle[i] =
        cage.add(center() + ModelVector{(static_cast<double>(i) - 1) * 0.6, 0, -k_eye_radius * 1.18}, {-3, 5, 0});
  }
  const std::array<std::uint32_t, 5> low{last[7], last[8], last[9], last[10], last[11]};
  const std::array<std::uint32_t, 5> mid{last[6], middle[0], middle[1], middle[2], last[0]};
  const std::array<std::uint32_t, 5> high{last[5], last[4], last[3], last[2], last[1]};
  for (std::size_t i = 0; i < 4; ++i) {
    cage.add_quad(low[i], low[i + 1], mid[i + 1], mid[i], QuadKind::coarse_skin);
    cage.add_quad(mid[i], mid[i + 1], high[i + 1], high[i], QuadKind::coarse_skin);
  }
}

}  // namespace penpose::head
