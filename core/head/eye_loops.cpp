#include <cmath>

#include "core/head/cage.h"

namespace penpose::head {
namespace {

constexpr std::size_t k_count = 12;
struct Offset {
  double x, y;
};
using Loop = std::array<Offset, k_count>;

// Loops relative to the eye's centre as seen from the front, counter-clockwise from the outer corner.
constexpr Loop k_rim{{{1.34, 0.12}, {1.08, 0.58}, {0.64, 0.88}, {0.05, 1.0}, {-0.56, 0.84}, {-1.04, 0.40},
                      {-1.42, -0.24}, {-1.04, -0.50}, {-0.56, -0.66}, {0.02, -0.74}, {0.6, -0.64}, {1.08, -0.32}}};
constexpr Loop k_lid{{{1.52, 0.10}, {1.24, 0.76}, {0.74, 1.12}, {0.05, 1.24}, {-0.64, 1.06}, {-1.18, 0.56},
                      {-1.60, -0.27}, {-1.17, -0.66}, {-0.62, -0.88}, {0.02, -0.97}, {0.68, -0.86}, {1.25, -0.45}}};
constexpr Loop k_crease{{{1.86, 0.08}, {1.47, 1.02}, {0.84, 1.44}, {0.05, 1.56}, {-0.74, 1.36}, {-1.38, 0.78},
                         {-1.78, -0.30}, {-1.38, -0.98}, {-0.72, -1.30}, {0.0, -1.42}, {0.8, -1.28}, {1.52, -0.75}}};
constexpr std::array<double, k_count> k_crease_depth{0.42, 0.98, 1.32, 1.42, 1.42, 1.32, 1.20, 1.42, 1.52, 1.46, 1.18, 0.66};
constexpr double k_rim_thickness = 0.17;

ModelPoint center() { return {k_eye_center[0], k_eye_center[1], k_eye_center[2]}; }

ModelPoint on_sphere(const Offset& o, double radius) {
  return center() + ModelVector{o.x, o.y, std::sqrt(radius * radius - o.x * o.x - o.y * o.y)};
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
    loops[0].push_back(cage.add(center() + ModelVector{k_crease[i].x, k_crease[i].y, k_crease_depth[i]}, {3, 5, 0}));
    loops[1].push_back(cage.add(on_sphere(k_lid[i], k_eye_radius + 0.24), {2, 5, 0}));
    loops[2].push_back(cage.add(on_sphere(edge, k_eye_radius + 0.04 + k_rim_thickness), {1, 5, 0}));
    loops[3].push_back(cage.add(on_sphere(rim, k_eye_radius + 0.03), {0, 5, 0}));
    loops[4].push_back(cage.add(center() + outward * (pocket * 0.98) + ModelVector{0, 0, pocket * 0.15}, {-1, 5, 0}));
    loops[5].push_back(cage.add(center() + outward * (pocket * 0.8) + ModelVector{0, 0, -pocket * 0.75}, {-2, 5, 0}));
  }
  cage.add_strip(border, loops[0], true);
  for (std::size_t i = 0; i + 1 < loops.size(); ++i) cage.add_strip(loops[i], loops[i + 1], true, i >= 3);
  // The back of the socket: the last loop as a rectangle of 4 x 2 quads.
  const auto& last = loops.back();
  std::array<std::uint32_t, 3> middle{};
  for (std::size_t i = 0; i < 3; ++i) {
    middle[i] = cage.add(center() + ModelVector{(static_cast<double>(i) - 1) * 0.6, 0, -k_eye_radius * 1.18}, {-3, 5, 0});
  }
  const std::array<std::uint32_t, 5> low{last[7], last[8], last[9], last[10], last[11]};
  const std::array<std::uint32_t, 5> mid{last[6], middle[0], middle[1], middle[2], last[0]};
  const std::array<std::uint32_t, 5> high{last[5], last[4], last[3], last[2], last[1]};
  for (std::size_t i = 0; i < 4; ++i) {
    cage.add_quad(low[i], low[i + 1], mid[i + 1], mid[i], true);
    cage.add_quad(mid[i], mid[i + 1], high[i + 1], high[i], true);
  }
}

}  // namespace penpose::head
