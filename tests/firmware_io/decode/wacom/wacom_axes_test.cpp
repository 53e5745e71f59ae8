#include "firmware_io/decode/wacom/wacom_axes.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

TEST(WacomAxes, LeaveOutTheMarginAroundAPicture) {
  const PenAxes axes = wacom_axes({0xfa, WacomFamily::cintiq_hd, "Cintiq 22HD", 95840, 54260, 2047, 63, 200, 400});
  EXPECT_EQ(axes.x.minimum, 400);
  EXPECT_EQ(axes.x.maximum, 95440);
  EXPECT_EQ(axes.y.maximum, 53860);
  EXPECT_EQ(axes.x.units_per_mm, 200);
  EXPECT_EQ(axes.pressure.maximum, 2047);
  EXPECT_TRUE(axes.distance.present);
  EXPECT_FALSE(axes.tilt_x.present);
}

TEST(WacomAxes, TiltAndRotationAreAdded) {
  PenAxes axes = wacom_axes({0x30, WacomFamily::pl, "PL400", 5408, 4056, 255, 0, 20, 0});
  EXPECT_FALSE(axes.distance.present);
  add_wacom_tilt(axes);
  add_wacom_rotation_and_wheel(axes, false);
  EXPECT_EQ(axes.tilt_y.minimum, -64);
  EXPECT_FALSE(axes.rotation.present);
  EXPECT_EQ(axes.wheel.maximum, 1023);
  add_wacom_rotation_and_wheel(axes, true);
  EXPECT_EQ(axes.rotation.maximum, 899);
}

}  // namespace
}  // namespace penpose::decode
