#include "core/head/sculpt.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::head {
namespace {

constexpr LoopMark k_plain{5, 5, 0};

TEST(Sculpt, FaceMovesAndLidsAndBackDoNot) {
  const ModelPoint chin{0, -9.7, 8.2};
  EXPECT_GT(carved(chin, k_plain).z, chin.z + 0.3);
  const ModelPoint cheek{3.8, -3.2, 7.6};
  EXPECT_GT(carved(cheek, k_plain).z, cheek.z + 0.2);
  EXPECT_EQ(carved(cheek, {1, 5, 0}), cheek);
  const ModelPoint back{3, 2, -8};
  EXPECT_EQ(carved(back, k_plain), back);
}

TEST(Sculpt, PointsOfThePlaneStayOnIt) {
  for (double y = -12; y < 8; y += 0.25) EXPECT_EQ(carved({0, y, 8.5}, k_plain).x, 0);
}

TEST(Sculpt, BrowGetsSlimWithoutFolding) {
  for (const double x : {1.0, 2.5, 4.0, 5.2, 5.6}) {
    double last = -1e300;
    for (double y = 0.5; y < 7; y += 0.02) {
      const double moved = with_brow({x, y, bare_depth(x, y)}, k_plain).y;
      EXPECT_GT(moved, last) << x << " " << y;
      last = moved;
    }
    const double line = brow_line(x);
    const double above = with_brow({x, line + 0.6, bare_depth(x, line + 0.6)}, k_plain).y - line;
    EXPECT_GT(above, 0);
    EXPECT_LT(above, 0.45);
  }
}

}  // namespace
}  // namespace penpose::head
