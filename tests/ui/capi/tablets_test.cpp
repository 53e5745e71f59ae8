#include <gtest/gtest.h>

#include "replay/session/virtual_pen.h"
#include "tests/support/c_desk.h"

namespace penpose::tests {
namespace {

TEST(CTablets, ADescriptorAndReportsGiveSamples) {
  CDesk desk;
  const decode::DeviceIdentity identity = replay::virtual_pen_identity();
  const penpose_interface interface_of{identity.bus,
                                       identity.vendor,
                                       identity.product,
                                       identity.name.c_str(),
                                       identity.report_descriptor.data(),
                                       identity.report_descriptor.size()};
  penpose_handle tablet = 0;
  penpose_axes axes{};
  ASSERT_EQ(penpose_tablet(desk.open, &interface_of, &tablet, &axes, &desk.error), PENPOSE_OK) << desk.error.message;
  EXPECT_EQ(axes.x.present, 1);
  EXPECT_EQ(axes.wheel.present, 0);
  penpose_sample samples[16];
  std::size_t count = 0;
  const auto feed = [&](double x, bool tip, bool eraser) {
    const auto report = replay::virtual_pen_report({{x, 500}, 0.5, true, tip, eraser, false}, {1000, 1000});
    EXPECT_EQ(penpose_tablet_report(desk.open, tablet, report.data(), report.size(), samples, 16, &count, nullptr),
              PENPOSE_OK);
    EXPECT_EQ(count, 1U);
  };
  feed(250, true, false);
  const double first = samples[0].x;
  EXPECT_EQ(samples[0].tip, 1);
  EXPECT_EQ(samples[0].in_range, 1);
  EXPECT_EQ(samples[0].tool, PENPOSE_TOOL_PEN);
  EXPECT_NEAR(samples[0].pressure, (axes.pressure.minimum + axes.pressure.maximum) / 2.0, 2);
  feed(750, false, false);
  EXPECT_NEAR(samples[0].x - first, (axes.x.maximum - axes.x.minimum) / 2.0, 70) << "half of the picture further";
  EXPECT_EQ(samples[0].tip, 0);
  // No room: the number is told.
  const auto report = replay::virtual_pen_report({{1, 1}, 0.5, true, true, false, false}, {1000, 1000});
  EXPECT_EQ(penpose_tablet_report(desk.open, tablet, report.data(), report.size(), nullptr, 0, &count, nullptr),
            PENPOSE_TOO_SMALL);
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(penpose_tablet_report(desk.open, tablet, "", 0, samples, 16, &count, nullptr), PENPOSE_OK);
  EXPECT_EQ(count, 0U) << "an empty report says nothing";
}

TEST(CTablets, WhatIsNoTabletIsRefused) {
  CDesk desk;
  const penpose_interface nothing{3, 0x1234, 0x5678, nullptr, nullptr, 0};
  penpose_handle tablet = 0;
  EXPECT_EQ(penpose_tablet(desk.open, &nothing, &tablet, nullptr, &desk.error), PENPOSE_REFUSED);
  EXPECT_STRNE(desk.error.message, "");
  EXPECT_EQ(tablet, 0U);
}

}  // namespace
}  // namespace penpose::tests
