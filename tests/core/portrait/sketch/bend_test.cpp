#include "core/portrait/sketch/bend.h"

#include <gtest/gtest.h>

namespace penpose::portrait {
namespace {

TEST(Bend, AParabolaHasItsOwnCoefficients) {
  FaceMark mark;
  for (int i = 0; i <= 400; ++i) {
    const double t = i / 200.0 - 1;
    mark.points.push_back({3 + 2 * t, 0.5 + 0.1 * t + 0.02 * (t * t - 1.0 / 3.0)});
  }
  mark.low = {1, 0.4};
  mark.high = {5, 0.7};
  const Marks marks{&mark};
  const Bend bend = bend_of(marks, extent_of(marks));
  EXPECT_NEAR(bend.at, 0.5, 1e-3);
  EXPECT_NEAR(bend.slope, 0.1, 1e-3);
  EXPECT_NEAR(bend.curve, 0.02, 1e-3);
}

}  // namespace
}  // namespace penpose::portrait
