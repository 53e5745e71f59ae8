#include "core/head/cage.h"

namespace penpose::head {
namespace {

constexpr std::size_t k_count = 11;
/// Position as seen from the front, and height above the bare face.
struct Spot {
  double x, y, lift;
};
using Loop = std::array<Spot, k_count>;

// From the middle of the lower lip over the corner (entry 5) to the middle of the upper lip.
constexpr Loop k_around{{{0, -7.72, -0.02}, {0.6, -7.68, -0.02}, {1.2, -7.52, 0.0}, {1.85, -7.22, 0.02}, {2.45, -6.85, 0.02},
                         {2.92, -6.48, 0.0},
                         {2.5, -6.08, 0.04}, {1.9, -5.78, 0.06}, {1.25, -5.55, 0.08}, {0.55, -5.42, 0.1}, {0, -5.5, 0.04}}};
constexpr Loop k_border{{{0, -7.32, 0.2}, {0.5, -7.3, 0.2}, {1.05, -7.18, 0.18}, {1.65, -6.96, 0.12}, {2.15, -6.72, 0.02},
                         {2.58, -6.47, -0.12},
                         {2.2, -6.27, 0.02}, {1.65, -6.04, 0.14}, {1.05, -5.83, 0.22}, {0.45, -5.68, 0.28}, {0, -5.8, 0.25}}};
constexpr Loop k_full{{{0, -6.88, 0.5}, {0.5, -6.88, 0.5}, {1.05, -6.82, 0.43}, {1.6, -6.72, 0.3}, {2.05, -6.6, 0.1},
                       {2.4, -6.46, -0.15},
                       {2.08, -6.37, 0.1}, {1.62, -6.3, 0.28}, {1.05, -6.2, 0.4}, {0.48, -6.13, 0.47}, {0, -6.15, 0.5}}};
constexpr Loop k_meet{{{0, -6.53, 0.2}, {0.5, -6.53, 0.2}, {1.05, -6.51, 0.14}, {1.6, -6.49, 0.02}, {2.0, -6.47, -0.15},
                       {2.3, -6.45, -0.3},
                       {2.0, -6.45, -0.15}, {1.6, -6.47, 0.02}, {1.05, -6.49, 0.14}, {0.5, -6.51, 0.2}, {0, -6.51, 0.2}}};
constexpr Loop k_behind{{{0, -6.85, -0.5}, {0.5, -6.85, -0.5}, {1.05, -6.82, -0.55}, {1.6, -6.75, -0.65}, {2.05, -6.6, -0.75},
                         {2.35, -6.45, -0.85},
                         {2.05, -6.3, -0.75}, {1.6, -6.2, -0.65}, {1.05, -6.15, -0.55}, {0.5, -6.12, -0.5}, {0, -6.12, -0.5}}};
constexpr Loop k_cavity{{{0, -7.5, -2.0}, {0.5, -7.5, -2.0}, {1.1, -7.45, -2.0}, {1.7, -7.3, -2.0}, {2.2, -7.0, -1.9},
                         {2.5, -6.45, -1.9},
                         {2.2, -5.9, -1.9}, {1.7, -5.6, -2.0}, {1.1, -5.5, -2.0}, {0.5, -5.45, -2.0}, {0, -5.45, -2.0}}};

}  // namespace

void add_mouth(Cage& cage, const std::vector<std::uint32_t>& border) {
  for (const std::uint32_t v : border) cage.marks[v].y = 4;
  const std::array<const Loop*, 6> shapes{&k_around, &k_border, &k_full, &k_meet, &k_behind, &k_cavity};
  constexpr std::array<QuadKind, 6> kinds{QuadKind::skin, QuadKind::skin, QuadKind::lip,
                                          QuadKind::lip,  QuadKind::lip,  QuadKind::coarse_skin};
  std::vector<std::uint32_t> outer = border;
  const auto lip = [](std::size_t i) { return i == 5 ? 0.0 : i < 5 ? -1.0 : 1.0; };
  for (std::size_t loop = 0; loop < shapes.size(); ++loop) {
    std::vector<std::uint32_t> inner;
    for (std::size_t i = 0; i < k_count; ++i) {
      const Spot& s = (*shapes[loop])[i];
      inner.push_back(cage.add({s.x, s.y, bare_depth(s.x, s.y) + s.lift}, {5, 3 - static_cast<double>(loop), lip(i)}));
    }
    cage.add_strip(outer, inner, false, kinds[loop]);
    outer = inner;
  }
  // The back of the cavity: the last loop as a rectangle of 4 x 2 quads.
  std::array<std::uint32_t, 5> middle{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = 0.6 * static_cast<double>(i);
    middle[i] = cage.add({x, k_mouth_y, bare_depth(x, k_mouth_y) - 3.2}, {5, -3, 0});
  }
  middle[4] = outer[5];
  for (std::size_t i = 0; i < 4; ++i) {
    cage.add_quad(outer[i], outer[i + 1], middle[i + 1], middle[i], QuadKind::coarse_skin);
    cage.add_quad(middle[i], middle[i + 1], outer[9 - i], outer[10 - i], QuadKind::coarse_skin);
  }
}

}  // namespace penpose::head
