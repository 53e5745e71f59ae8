#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/head/cage.h"

namespace penpose::head {
namespace {

constexpr std::size_t k_eye_points = 12;
struct Offset {
  double x, y;
};
using EyeLoop = std::array<Offset, k_eye_points>;

// Loops relative to the eye's centre as seen from the front, counter-clockwise from the outer corner; cm.
constexpr EyeLoop k_rim{{{1.92, 0.04},
                         {1.34, 0.30},
                         {0.84, 0.49},
                         {0.14, 0.56},
                         {-0.54, 0.49},
                         {-1.08, 0.24},
                         {-1.74, -0.16},
                         {-1.06, -0.38},
                         {-0.52, -0.54},
                         {0.14, -0.60},
                         {0.80, -0.52},
                         {1.36, -0.26}}};
constexpr EyeLoop k_lid{{{2.14, 0.04},
                         {1.66, 0.70},
                         {1.02, 1.06},
                         {0.14, 1.20},
                         {-0.68, 1.06},
                         {-1.34, 0.62},
                         {-1.92, -0.18},
                         {-1.26, -0.70},
                         {-0.62, -0.94},
                         {0.14, -1.03},
                         {0.94, -0.92},
                         {1.62, -0.48}}};
constexpr EyeLoop k_crease{{{2.42, 0.04},
                            {1.89, 1.18},
                            {1.17, 1.64},
                            {0.23, 1.78},
                            {-0.68, 1.58},
                            {-1.42, 0.92},
                            {-2.04, -0.26},
                            {-1.44, -1.14},
                            {-0.67, -1.51},
                            {0.18, -1.66},
                            {1.12, -1.49},
                            {1.96, -0.88}}};
/// How far in front of the eye's centre the crease lies, cm.
constexpr std::array<double, k_eye_points> k_crease_depth{1.50, 1.76, 2.02, 2.14, 2.20, 2.26,
                                                          2.30, 2.50, 2.60, 2.52, 2.20, 1.68};
/// Width of the lids' edges as seen from the front, cm; the upper one carries the lashes.
constexpr double k_upper_edge = 0.16;
constexpr double k_lower_edge = 0.06;
constexpr double k_corner_edge = 0.04;

ModelPoint center() { return {k_eye_center[0], k_eye_center[1], k_eye_center[2]}; }

/// The point of a sphere of `radius` eye radii that is seen at an offset.
ModelPoint on_sphere(const Offset& o, double radius) {
  const double r = radius * k_eye_radius;
  return center() + ModelVector{o.x, o.y, std::sqrt(r * r - o.x * o.x - o.y * o.y)};
}

/// +1 for the upper lid, -1 for the lower, 0 for the corners.
double lid_of(std::size_t i) { return i % (k_eye_points / 2) == 0 ? 0.0 : i < k_eye_points / 2 ? 1.0 : -1.0; }

}  // namespace

void add_eye(Cage& cage, const std::vector<std::uint32_t>& border) {
  for (const std::uint32_t v : border) cage.marks[v].x = 4;
  std::array<std::vector<std::uint32_t>, 7> loops;
  for (std::size_t i = 0; i < k_eye_points; ++i) {
    const Offset& rim = k_rim[i];
    const double lid = lid_of(i);
    const double around = std::sqrt(rim.x * rim.x + rim.y * rim.y);
    const double width = lid > 0 ? k_upper_edge : lid < 0 ? k_lower_edge : k_corner_edge;
    const Offset edge{rim.x + width * rim.x / around, rim.y + width * (rim.y / around + 0.3 * lid)};
    const double turn = 2 * base::k_pi * static_cast<double>(i) / k_eye_points;
    const ModelVector outward{base::cos(turn), base::sin(turn), 0};
    const double pocket = k_eye_radius * 1.06;
    const ModelVector crease{k_crease[i].x, k_crease[i].y, k_crease_depth[i]};
    loops[0].push_back(cage.add(center() + crease, {3, 5, lid}));
    loops[1].push_back(cage.add(on_sphere(k_lid[i], lid > 0 ? 1.09 : 1.035), {2, 5, lid}));
    loops[2].push_back(cage.add(on_sphere(edge, 1.012), {1, 5, lid}));
    loops[3].push_back(cage.add(on_sphere(rim, 1.002), {0, 5, lid}));
    // Close behind the rim, so that the way around the ball does not pull it open.
    loops[4].push_back(cage.add(on_sphere({rim.x * 1.3, rim.y * 1.7}, 1.002), {-1, 5, lid}));
    loops[5].push_back(cage.add(center() + outward * (pocket * 0.98) + ModelVector{0, 0, pocket * 0.15}, {-1.5, 5, 0}));
    loops[6].push_back(cage.add(center() + outward * (pocket * 0.8) + ModelVector{0, 0, -pocket * 0.75}, {-2, 5, 0}));
  }
  cage.add_strip(border, loops[0], true);
  std::fill_n(cage.kinds.end() - k_eye_points / 2, k_eye_points / 2, QuadKind::coarse_skin);  // below the eye
  for (std::size_t i = 0; i + 1 < loops.size(); ++i) {
    const std::size_t first = cage.quads.size();
    cage.add_strip(loops[i], loops[i + 1], true, i >= 3 ? QuadKind::coarse_skin : QuadKind::skin);
    // The edge of the upper lid.
    if (i == 2) std::fill_n(cage.kinds.begin() + static_cast<std::ptrdiff_t>(first), k_eye_points / 2, QuadKind::lash);
  }
  // The back of the socket: the last loop as a rectangle of 4 x 2 quads.
  const auto& last = loops.back();
  std::array<std::uint32_t, 3> middle{};
  for (std::size_t i = 0; i < 3; ++i) {
    middle[i] =
        cage.add(center() + ModelVector{(static_cast<double>(i) - 1) * 0.85, 0, -k_eye_radius * 1.15}, {-3, 5, 0});
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
