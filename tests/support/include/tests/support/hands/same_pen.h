#pragma once

#include <gtest/gtest.h>

#include "firmware_io/decode/sample/pen_sample.h"

namespace penpose::tests {

/// What every pen says: where it is, what it is, how it is pressed. Tilt, distance and the rest are for some alone.
inline void expect_same_pen(const decode::PenSample& got, const decode::PenSample& wanted) {
  EXPECT_EQ(got.in_range, wanted.in_range);
  EXPECT_EQ(got.tool, wanted.tool);
  EXPECT_EQ(got.x, wanted.x);
  EXPECT_EQ(got.y, wanted.y);
  EXPECT_EQ(got.pressure, wanted.pressure);
  EXPECT_EQ(got.tip, wanted.tip);
  EXPECT_EQ(got.buttons, wanted.buttons);
}

}  // namespace penpose::tests
