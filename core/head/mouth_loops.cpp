#include "core/head/cage.h"

namespace penpose::head {
namespace {

constexpr std::size_t k_mouth_points = 11;
/// Sideways, above the line where the lips meet, and in front of the bare face.
struct Spot {
  double x, height, lift;
};
using MouthLoop = std::array<Spot, k_mouth_points>;

// From the middle of the lower lip over the corner (entry 5) to the middle of the upper lip. At the line both lips are
// drawn a little too far; make_half presses them flat against each other.
constexpr MouthLoop k_around_mouth{{{0, -1.25, -0.02},
                                    {0.6, -1.22, -0.02},
                                    {1.2, -1.1, 0},
                                    {1.85, -0.82, 0.02},
                                    {2.5, -0.44, 0.02},
                                    {2.98, 0, 0},
                                    {2.6, 0.42, 0.04},
                                    {1.95, 0.74, 0.06},
                                    {1.25, 1, 0.08},
                                    {0.5, 1.12, 0.1},
                                    {0, 1.02, 0.04}}};
constexpr MouthLoop k_border{{{0, -0.92, 0.2},
                              {0.5, -0.9, 0.2},
                              {1.05, -0.79, 0.18},
                              {1.65, -0.56, 0.12},
                              {2.2, -0.28, 0.02},
                              {2.62, 0, -0.12},
                              {2.25, 0.26, 0.02},
                              {1.65, 0.47, 0.14},
                              {1.05, 0.68, 0.22},
                              {0.42, 0.84, 0.28},
                              {0, 0.72, 0.25}}};
constexpr MouthLoop k_full{{{0, -0.42, 0.62},
                            {0.5, -0.42, 0.6},
                            {1.05, -0.36, 0.5},
                            {1.6, -0.26, 0.33},
                            {2.08, -0.14, 0.1},
                            {2.42, 0, -0.15},
                            {2.1, 0.13, 0.1},
                            {1.62, 0.23, 0.28},
                            {1.05, 0.33, 0.42},
                            {0.46, 0.4, 0.52},
                            {0, 0.36, 0.56}}};
constexpr MouthLoop k_meet{{{0, 0.22, 0.22},
                            {0.5, 0.22, 0.22},
                            {1.05, 0.2, 0.16},
                            {1.6, 0.16, 0.03},
                            {2.02, 0.08, -0.13},
                            {2.32, 0, -0.3},
                            {2.02, -0.08, -0.13},
                            {1.6, -0.16, 0.03},
                            {1.05, -0.2, 0.16},
                            {0.5, -0.22, 0.22},
                            {0, -0.22, 0.22}}};
constexpr MouthLoop k_behind{{{0, -0.3, -0.5},
                              {0.5, -0.3, -0.5},
                              {1.05, -0.28, -0.55},
                              {1.6, -0.22, -0.65},
                              {2.05, -0.12, -0.75},
                              {2.35, 0, -0.85},
                              {2.05, 0.12, -0.75},
                              {1.6, 0.22, -0.65},
                              {1.05, 0.28, -0.55},
                              {0.5, 0.3, -0.5},
                              {0, 0.3, -0.5}}};
constexpr MouthLoop k_cavity{{{0, -1, -2},
                              {0.5, -1, -2},
                              {1.1, -0.95, -2},
                              {1.7, -0.8, -2},
                              {2.2, -0.5, -1.9},
                              {2.5, 0, -1.9},
                              {2.2, 0.55, -1.9},
                              {1.7, 0.9, -2},
                              {1.1, 1, -2},
                              {0.5, 1.05, -2},
                              {0, 1.05, -2}}};

}  // namespace

double mouth_line(double x) { return k_mouth_y + 0.035 * x * x - 0.05 * bump(x * x); }

void add_mouth(Cage& cage, const std::vector<std::uint32_t>& border) {
  for (const std::uint32_t v : border) cage.marks[v].y = 4;
  const std::array<const MouthLoop*, 6> shapes{&k_around_mouth, &k_border, &k_full, &k_meet, &k_behind, &k_cavity};
  // A mouth that opens shows what lies behind the line where the lips meet, and from the side as a wall.
  const std::array<QuadKind, 6> kinds{QuadKind::skin, QuadKind::skin,      QuadKind::lip,
                                      QuadKind::lip,  QuadKind::inner_lip, QuadKind::lining};
  std::vector<std::uint32_t> outer = border;
  const auto lip = [](std::size_t i) { return i == 5 ? 0.0 : i < 5 ? -1.0 : 1.0; };
  for (std::size_t loop = 0; loop < shapes.size(); ++loop) {
    std::vector<std::uint32_t> inner;
    for (std::size_t i = 0; i < k_mouth_points; ++i) {
      const Spot& s = (*shapes[loop])[i];
      const double y = mouth_line(s.x) + s.height;
      inner.push_back(cage.add({s.x, y, bare_depth(s.x, y) + s.lift}, {5, 3 - static_cast<double>(loop), lip(i)}));
    }
    cage.add_strip(outer, inner, false, kinds[loop]);
    outer = inner;
  }
  // The back of the cavity: the last loop as a rectangle of 4 x 2 quads.
  std::array<std::uint32_t, 5> middle{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = 0.6 * static_cast<double>(i);
    middle[i] = cage.add({x, mouth_line(x), bare_depth(x, mouth_line(x)) - 3.2}, {5, -3, 0});
  }
  middle[4] = outer[5];
  for (std::size_t i = 0; i < 4; ++i) {
    cage.add_quad(outer[i], outer[i + 1], middle[i + 1], middle[i], QuadKind::lining);
    cage.add_quad(middle[i], middle[i + 1], outer[9 - i], outer[10 - i], QuadKind::lining);
  }
}

}  // namespace penpose::head
