#include "core/head/cage.h"

namespace penpose::head {
namespace {

using EarLoop = std::array<ModelPoint, 8>;

// From the upper front corner down the front, and up the back; seen from +x.
constexpr double k_out = 6.95;
const EarLoop k_root{{{k_out + 0.3, 0.35, 0.75},
                      {k_out + 0.3, -0.4, 0.85},
                      {k_out + 0.2, -1.3, 0.75},
                      {k_out + 0.05, -2, 0.4},
                      {k_out + 0.2, -2, -0.7},
                      {k_out + 0.5, -1.3, -1.2},
                      {k_out + 0.62, -0.3, -1.3},
                      {k_out + 0.5, 0.45, -0.8}}};
const EarLoop k_back{{{k_out + 0.42, 1.35, 0.8},
                      {k_out + 0.4, -0.3, 1.05},
                      {k_out + 0.3, -1.7, 0.95},
                      {k_out + 0.18, -3.1, 0.3},
                      {k_out + 0.4, -3.15, -0.75},
                      {k_out + 1, -1.6, -1.95},
                      {k_out + 1.25, 0.3, -2.35},
                      {k_out + 1, 1.75, -1.45}}};
const EarLoop k_helix{{{k_out + 0.78, 1.5, 0.65},
                       {k_out + 0.55, -0.25, 0.95},
                       {k_out + 0.48, -1.75, 0.85},
                       {k_out + 0.5, -3.25, 0.3},
                       {k_out + 0.78, -3.2, -0.7},
                       {k_out + 1.38, -1.6, -1.85},
                       {k_out + 1.66, 0.35, -2.2},
                       {k_out + 1.42, 1.85, -1.35}}};
const EarLoop k_fold{{{k_out + 0.68, 0.95, 0.3},
                      {k_out + 0.48, -0.25, 0.62},
                      {k_out + 0.5, -1.6, 0.55},
                      {k_out + 0.62, -2.35, 0.1},
                      {k_out + 0.82, -2.3, -0.5},
                      {k_out + 1.12, -1.35, -1.25},
                      {k_out + 1.3, 0.25, -1.5},
                      {k_out + 1.12, 1.2, -0.95}}};
const EarLoop k_shell{{{k_out + 0.3, 0.45, 0.05},
                       {k_out + -0.05, -0.3, 0.3},
                       {k_out + -0.05, -1.2, 0.3},
                       {k_out + 0.3, -1.75, 0},
                       {k_out + 0.45, -1.75, -0.3},
                       {k_out + 0.5, -1.1, -0.65},
                       {k_out + 0.6, 0.05, -0.8},
                       {k_out + 0.6, 0.55, -0.5}}};

}  // namespace

void add_ear(Cage& cage, const std::vector<std::uint32_t>& border) {
  std::vector<std::uint32_t> outer = border;
  for (const EarLoop* loop : {&k_root, &k_back, &k_helix, &k_fold, &k_shell}) {
    std::vector<std::uint32_t> inner;
    for (const ModelPoint& p : *loop) inner.push_back(cage.add(p, {5, 5, 3}));
    cage.add_strip(outer, inner, true, loop == &k_helix ? QuadKind::skin : QuadKind::coarse_skin);
    outer = inner;
  }
  for (std::size_t i = 0; i < 3; ++i)
    cage.add_quad(outer[i], outer[i + 1], outer[6 - i], outer[7 - i], QuadKind::coarse_skin);
}

}  // namespace penpose::head
