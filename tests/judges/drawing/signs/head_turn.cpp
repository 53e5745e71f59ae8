#include "tests/judges/drawing/signs/head_turn.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/algebra/symmetric_eigen.h"
#include "core/base/math.h"

namespace penpose::judges::drawn {
namespace {

using geometry::ModelPoint;

/// The turn that takes points `b` about their middle nearest to `a` about theirs.
glm::dquat turn_onto(std::span<const ModelPoint> a, std::span<const ModelPoint> b) {
  glm::dmat3 s(0);  // s[i][j]: sum of b_i a_j
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) s[i][j] += b[k][i] * a[k][j];
    }
  }
  const double x = s[1][2] - s[2][1], y = s[2][0] - s[0][2], z = s[0][1] - s[1][0];
  const double xy = s[0][1] + s[1][0], zx = s[2][0] + s[0][2], yz = s[1][2] + s[2][1];
  const auto eigen = algebra::symmetric_eigen({s[0][0] + s[1][1] + s[2][2], x, y, z,     //
                                               x, s[0][0] - s[1][1] - s[2][2], xy, zx,   //
                                               y, xy, -s[0][0] + s[1][1] - s[2][2], yz,  //
                                               z, zx, yz, -s[0][0] - s[1][1] + s[2][2]},
                                              4);
  const auto& v = eigen.vectors;
  return {v[0], v[1], v[2], v[3]};
}

}  // namespace

HeldStill without_head_turn(const CurvePlaces& rest, const CurvePlaces& posed,
                            std::span<const FaceSigns::Point> fixed) {
  if (fixed.size() < 3) return {posed, 0};
  std::vector<ModelPoint> a, b;
  ModelPoint middle_a(0), middle_b(0);
  for (const FaceSigns::Point& p : fixed) {
    a.push_back(rest[p.curve][p.index]);
    b.push_back(posed[p.curve][p.index]);
    middle_a += a.back() / static_cast<double>(fixed.size());
    middle_b += b.back() / static_cast<double>(fixed.size());
  }
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= middle_a, b[k] -= middle_b;
  const glm::dquat turn = turn_onto(a, b);
  HeldStill out{posed, base::degrees(2 * base::acos(std::min(1.0, std::abs(turn.w))))};
  for (auto& line : out.places) {
    for (ModelPoint& p : line) p = turn * (p - middle_b) + middle_a;
  }
  return out;
}

}  // namespace penpose::judges::drawn
