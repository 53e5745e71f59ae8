#include "core/head/cage.h"

namespace penpose::head {
namespace {

using Loop = std::array<ModelPoint, 8>;

// From the upper front corner down the front, and up the back; seen from +x.
constexpr double k_out = 6.95;
const Loop k_root{{{k_out + 0.2, 1.0, 0.75}, {k_out + 0.25, -0.2, 0.8}, {k_out + 0.15, -1.6, 0.65}, {k_out - 0.1, -2.9, 0.1},
                   {k_out + 0.1, -2.9, -0.75}, {k_out + 0.55, -1.5, -1.25}, {k_out + 0.7, 0.0, -1.3}, {k_out + 0.55, 1.25, -0.7}}};
const Loop k_back{{{k_out + 0.45, 1.5, 0.75}, {k_out + 0.4, -0.2, 0.95}, {k_out + 0.3, -1.8, 0.85}, {k_out + 0.15, -3.5, 0.15},
                   {k_out + 0.45, -3.3, -0.8}, {k_out + 1.1, -1.6, -1.9}, {k_out + 1.35, 0.2, -2.2}, {k_out + 1.1, 1.8, -1.35}}};
const Loop k_helix{{{k_out + 0.75, 1.45, 0.6}, {k_out + 0.6, -0.2, 0.85}, {k_out + 0.5, -1.8, 0.75}, {k_out + 0.45, -3.45, 0.2},
                    {k_out + 0.75, -3.25, -0.7}, {k_out + 1.4, -1.6, -1.75}, {k_out + 1.68, 0.2, -2.0}, {k_out + 1.42, 1.75, -1.25}}};
const Loop k_fold{{{k_out + 0.6, 0.95, 0.35}, {k_out + 0.45, -0.2, 0.5}, {k_out + 0.5, -1.7, 0.45}, {k_out + 0.5, -2.6, 0.05},
                   {k_out + 0.75, -2.45, -0.55}, {k_out + 1.15, -1.4, -1.3}, {k_out + 1.35, 0.15, -1.5}, {k_out + 1.15, 1.2, -0.9}}};
const Loop k_shell{{{k_out + 0.35, 0.5, 0.1}, {k_out + 0.1, -0.3, 0.3}, {k_out + 0.1, -1.4, 0.3}, {k_out + 0.35, -2.1, -0.05},
                    {k_out + 0.5, -2.0, -0.4}, {k_out + 0.55, -1.2, -0.75}, {k_out + 0.7, 0.05, -0.85}, {k_out + 0.7, 0.7, -0.5}}};

}  // namespace

void add_ear(Cage& cage, const std::vector<std::uint32_t>& border) {
  std::vector<std::uint32_t> outer = border;
  for (const Loop* loop : {&k_root, &k_back, &k_helix, &k_fold, &k_shell}) {
    std::vector<std::uint32_t> inner;
    for (const ModelPoint& p : *loop) inner.push_back(cage.add(p, {5, 5, 3}));
    cage.add_strip(outer, inner, true);
    outer = inner;
  }
  for (std::size_t i = 0; i < 3; ++i) cage.add_quad(outer[i], outer[i + 1], outer[6 - i], outer[7 - i]);
}

}  // namespace penpose::head
