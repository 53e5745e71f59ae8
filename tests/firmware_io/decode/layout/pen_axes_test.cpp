#include "firmware_io/decode/layout/pen_axes.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

/// The size (mm) that is left of one that a descriptor tells.
std::pair<double, double> corrected(double told_width, double told_height, double width, double height) {
  PenAxes axes;
  axes.x = {0, 32767, told_width > 0 ? 32767 / told_width : 0, true};
  axes.y = {0, 32767, told_height > 0 ? 32767 / told_height : 0, true};
  correct_size(axes, width, height);
  const auto size = [](const Axis& axis) { return axis.units_per_mm > 0 ? 32767 / axis.units_per_mm : 0; };
  return {size(axes.x), size(axes.y)};
}

void expect_size(std::pair<double, double> got, double width, double height) {
  EXPECT_NEAR(got.first, width, 1e-9);
  EXPECT_NEAR(got.second, height, 1e-9);
}

TEST(PenAxes, ASizeThatATabletCanHaveStays) {
  expect_size(corrected(254, 159, 300, 200), 254, 159);
  expect_size(corrected(344, 98, 0, 0), 344, 98);
}

TEST(PenAxes, OfASizeBeyondAllTabletsTheProportionsStay) {
  expect_size(corrected(1032, 645, 203, 127), 203, 127);
  expect_size(corrected(1032, 645, 0, 0), 1032, 645);
  expect_size(corrected(5, 4, 0, 0), 5, 4);
}

TEST(PenAxes, ProportionsOfNoTabletSayNothing) {
  expect_size(corrected(200, 12, 0, 0), 0, 0);
  expect_size(corrected(200, 0, 203, 127), 203, 127);
  expect_size(corrected(0, 0, 0, 0), 0, 0);
}

}  // namespace
}  // namespace penpose::decode
