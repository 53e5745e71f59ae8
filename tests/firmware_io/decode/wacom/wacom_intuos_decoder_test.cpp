#include "firmware_io/decode/wacom/wacom_intuos_decoder.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/sample/device_identity.h"
#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"

namespace penpose::decode {
namespace {

constexpr std::uint32_t k_grip_pen = 0x10802;
constexpr std::uint32_t k_grip_eraser = 0x1080a;
constexpr std::uint32_t k_serial = 0x9abcdef1;

WacomIntuosDecoder decoder_of(std::uint16_t product, std::uint16_t bus = k_bus_usb) {
  return WacomIntuosDecoder(*find_wacom_model(bus, k_vendor_wacom, product));
}

TEST(WacomIntuosDecoder, FollowsAPenOnItsPath) {
  auto decoder = decoder_of(0x00b9);
  const tests::PathLimits limits{44704, 27940, 2047, true, 10};
  bool near = false;
  for (PenSample sample : tests::pen_path(limits)) {
    if (!sample.in_range) {
      ASSERT_EQ(decoder.decode(tests::intuos_leave()), ReportKind::pen);
      EXPECT_FALSE(decoder.sample().in_range);
      near = false;
      continue;
    }
    const std::uint32_t number = sample.tool == Tool::eraser ? k_grip_eraser : k_grip_pen;
    if (!near) {
      EXPECT_EQ(decoder.decode(tests::intuos_enter(number, k_serial)), ReportKind::ignored);
    }
    near = true;
    ASSERT_EQ(decoder.decode(tests::intuos_pen(sample)), ReportKind::pen);
    sample.serial = k_serial;
    sample.tool_id = number == k_grip_pen ? 0x100802 : 0x10080a;
    EXPECT_EQ(decoder.sample(), sample);
  }
}

TEST(WacomIntuosDecoder, ReportsNothingOfAToolThatNeverEntered) {
  auto decoder = decoder_of(0x00b9);
  PenSample sample;
  sample.x = 100;
  EXPECT_EQ(decoder.decode(tests::intuos_pen(sample)), ReportKind::ignored);
  EXPECT_EQ(decoder.decode(tests::intuos_leave()), ReportKind::ignored);
}

TEST(WacomIntuosDecoder, InRangeWithoutPositionEndsContact) {
  auto decoder = decoder_of(0x00b9);
  tests::Report in_range(10);
  in_range[0] = 0x02;
  in_range[1] = 0x20;
  EXPECT_EQ(decoder.decode(in_range), ReportKind::ignored);
  PenSample sample;
  sample.x = 1000;
  sample.pressure = 500;
  decoder.decode(tests::intuos_enter(k_grip_pen, 1));
  decoder.decode(tests::intuos_pen(sample));
  EXPECT_TRUE(decoder.sample().tip);
  ASSERT_EQ(decoder.decode(in_range), ReportKind::pen);
  EXPECT_TRUE(decoder.sample().in_range);
  EXPECT_FALSE(decoder.sample().tip);
  EXPECT_EQ(decoder.sample().pressure, 0);
  EXPECT_EQ(decoder.sample().x, 1000);
  EXPECT_EQ(decoder.sample().distance, 63);
}

TEST(WacomIntuosDecoder, ModelsOfTenBitsHalveThePressure) {
  auto decoder = decoder_of(0x00b2);
  PenSample sample;
  sample.pressure = 2047;
  decoder.decode(tests::intuos_enter(0x823, 1));
  decoder.decode(tests::intuos_pen(sample));
  EXPECT_EQ(decoder.sample().pressure, 1023);
  EXPECT_EQ(decoder.axes().pressure.maximum, 1023);
}

TEST(WacomIntuosDecoder, ContactIsAThresholdOfPressure) {
  auto decoder = decoder_of(0x00b9);
  decoder.decode(tests::intuos_enter(k_grip_pen, 1));
  PenSample sample;
  sample.pressure = 10;
  decoder.decode(tests::intuos_pen(sample));
  EXPECT_FALSE(decoder.sample().tip);
  sample.pressure = 11;
  decoder.decode(tests::intuos_pen(sample));
  EXPECT_TRUE(decoder.sample().tip);
}

TEST(WacomIntuosDecoder, RotationAndWheelComeInTurnWithPressure) {
  auto decoder = decoder_of(0x00b9);
  decoder.decode(tests::intuos_enter(0x10804, 1));
  PenSample sample;
  sample.pressure = 800;
  sample.x = 50;
  decoder.decode(tests::intuos_pen(sample));
  tests::Report rotation = tests::intuos_pen(sample);
  rotation[1] = 0xea;
  rotation[6] = 0x20;
  rotation[7] = 0x00;
  ASSERT_EQ(decoder.decode(rotation), ReportKind::pen);
  EXPECT_EQ(decoder.sample().rotation, 450 - 0x100 / 2);
  EXPECT_EQ(decoder.sample().pressure, 800);
  rotation[6] = 0xff;
  rotation[7] = 0x20;
  decoder.decode(rotation);
  EXPECT_EQ(decoder.sample().rotation, (0x7f9 - 1) / 2 - 1350);
  tests::Report airbrush = tests::intuos_pen(sample);
  airbrush[1] = 0xf4;
  airbrush[6] = 0x80;
  airbrush[7] = 0xc0 | 32;
  decoder.decode(airbrush);
  EXPECT_EQ(decoder.sample().wheel, 0x203);
  EXPECT_EQ(decoder.sample().pressure, 800);
  EXPECT_EQ(decoder.sample().rotation, (0x7f9 - 1) / 2 - 1350);
}

TEST(WacomIntuosDecoder, TheFirstTwoGenerationsFollowTwoTools) {
  auto decoder = decoder_of(0x0042);
  const auto as_second = [](tests::Report report) {
    report[1] |= 1;
    return report;
  };
  decoder.decode(tests::intuos_enter(0x822, 1));
  decoder.decode(as_second(tests::intuos_enter(0x096, 2)));
  PenSample sample;
  sample.x = 2000;
  sample.y = 1000;
  decoder.decode(tests::intuos_pen(sample));
  EXPECT_EQ(decoder.sample().tool, Tool::pen);
  EXPECT_EQ(decoder.sample().serial, 1u);
  EXPECT_EQ(decoder.sample().x, 1000);
  tests::Report lens = as_second(tests::intuos_pen(sample));
  lens[1] = 0xf1;
  lens[8] = 0x05;
  decoder.decode(lens);
  EXPECT_EQ(decoder.sample().tool, Tool::mouse);
  EXPECT_EQ(decoder.sample().serial, 2u);
  EXPECT_EQ(decoder.sample().buttons, 0b11u);
}

TEST(WacomIntuosDecoder, MiceHaveTheirOwnButtons) {
  auto decoder = decoder_of(0x00b9);
  decoder.decode(tests::intuos_enter(0x806, 1));
  tests::Report mouse = tests::intuos_pen({});
  mouse[1] = 0xec;
  mouse[6] = 0x0d;
  ASSERT_EQ(decoder.decode(mouse), ReportKind::pen);
  EXPECT_EQ(decoder.sample().tool, Tool::mouse);
  EXPECT_EQ(decoder.sample().buttons, 0b1011u);
  EXPECT_FALSE(decoder.sample().tip);
}

TEST(WacomIntuosDecoder, WhatSomeModelsRefuse) {
  PenSample sample;
  auto cintiq = decoder_of(0x003f);  // counts only data with the ready bit
  cintiq.decode(tests::intuos_enter(0x823, 1));
  tests::Report not_ready = tests::intuos_pen(sample);
  not_ready[1] = 0xa0;
  EXPECT_EQ(cintiq.decode(not_ready), ReportKind::ignored);
  EXPECT_EQ(cintiq.decode(tests::intuos_pen(sample)), ReportKind::pen);
  auto later = decoder_of(0x00cc);  // takes none of the pens before it
  later.decode(tests::intuos_enter(0x802, 1));
  EXPECT_EQ(later.decode(tests::intuos_pen(sample)), ReportKind::ignored);
  auto small = decoder_of(0x00b0);  // no lens cursor
  small.decode(tests::intuos_enter(0x097, 1));
  EXPECT_EQ(small.decode(tests::intuos_pen(sample)), ReportKind::ignored);
}

TEST(WacomIntuosDecoder, TouchStatusPadAndShortReportsAreNoPen) {
  auto decoder = decoder_of(0x0026);
  decoder.decode(tests::intuos_enter(k_grip_pen, 1));
  tests::Report touch(64);
  touch[0] = 0x02;
  touch[1] = 0xe0;
  EXPECT_EQ(decoder.decode(touch), ReportKind::ignored);
  EXPECT_EQ(decoder.decode(tests::Report{0xc0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), ReportKind::ignored);
  EXPECT_EQ(decoder.decode(tests::Report{0x02, 0xe0, 1, 2, 3}), ReportKind::ignored);
  EXPECT_EQ(decoder.decode({}), ReportKind::ignored);
  EXPECT_EQ(decoder.decode(tests::Report{0x03, 0, 0x85, 1, 6, 0, 0, 0, 0, 0}), ReportKind::ignored);
}

TEST(WacomIntuosDecoder, BluetoothReportsHoldSeveral) {
  auto decoder = decoder_of(0x00bd, k_bus_bluetooth);
  PenSample first;
  first.x = 10;
  PenSample second;
  second.x = 20;
  tests::Report whole{0x04};
  for (const auto& part : {tests::intuos_enter(k_grip_pen, 7), tests::intuos_pen(first), tests::intuos_pen(second)}) {
    whole.insert(whole.end(), part.begin(), part.end());
  }
  ASSERT_EQ(decoder.decode(whole), ReportKind::pen);
  ASSERT_EQ(decoder.frames().size(), 2u);
  EXPECT_EQ(decoder.frames()[0].x, 10);
  EXPECT_EQ(decoder.frames()[1].x, 20);
  whole.resize(20);
  EXPECT_EQ(decoder.decode(whole), ReportKind::ignored);
}

TEST(WacomIntuosDecoder, ConsumerModelsOf2015HaveNoTilt) {
  auto decoder = decoder_of(0x033b);
  EXPECT_FALSE(decoder.axes().tilt_x.present);
  PenSample sample;
  sample.tilt_x = 20;
  sample.distance = 60;
  tests::Report enter = tests::intuos_enter(0x8e2, 1);
  tests::Report pen = tests::intuos_pen(sample);
  enter[0] = pen[0] = 0x10;
  decoder.decode(enter);
  ASSERT_EQ(decoder.decode(pen), ReportKind::pen);
  EXPECT_EQ(decoder.sample().tilt_x, 0);
  EXPECT_EQ(decoder.sample().distance, 3);
}

TEST(WacomIntuosDecoder, ResetForgetsTheTool) {
  auto decoder = decoder_of(0x00b9);
  decoder.decode(tests::intuos_enter(k_grip_pen, 1));
  decoder.reset();
  EXPECT_EQ(decoder.decode(tests::intuos_pen({})), ReportKind::ignored);
}

}  // namespace
}  // namespace penpose::decode
