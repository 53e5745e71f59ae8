#include "firmware_io/decode/wacom/hand/wacom_pad_decoder.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "tests/support/hands/pen_reports.h"

namespace penpose::decode {
namespace {

using tests::Report;

WacomPadDecoder pad_of(std::uint16_t product, std::uint16_t bus = k_bus_usb) {
  return WacomPadDecoder(*find_wacom_hand(bus, k_vendor_wacom, product));
}
std::string held(const WacomPadDecoder& pad) { return key_names(pad.sample().keys); }

TEST(WacomPadDecoder, KeysRingAndLightOfAnIntuosPro) {
  auto pad = pad_of(0x0314);
  EXPECT_EQ(key_names(pad.features().keys), "BTN_0+BTN_1+BTN_2+BTN_3+BTN_4+BTN_5+BTN_6");
  EXPECT_EQ(pad.features().rings, 1u);
  ASSERT_TRUE(pad.decode(Report{0x03, 0, 0x85, 1, 6, 0, 0, 0, 0, 0}));
  EXPECT_EQ(held(pad), "BTN_0+BTN_2+BTN_3");
  EXPECT_EQ(pad.sample().ring[0], 5);
  EXPECT_TRUE(pad.sample().ring_touched[0]);
  EXPECT_EQ(pad.sample().mode[0], 1);
  ASSERT_TRUE(pad.decode(Report{0x03, 0, 0x05, 0, 0xff, 0, 0, 0, 0, 0}));
  EXPECT_EQ(held(pad), "BTN_1+BTN_2+BTN_3+BTN_4+BTN_5+BTN_6");
  EXPECT_EQ(pad.sample().ring[0], 0);
  EXPECT_FALSE(pad.sample().ring_touched[0]);
  EXPECT_EQ(pad.sample().mode[0], 1);
  pad.reset();
  EXPECT_EQ(pad.sample(), PadSample{});
}

TEST(WacomPadDecoder, ReportsOfPenAndFingersSayNothing) {
  auto pad = pad_of(0x0314);
  Report fingers(64);
  fingers[0] = 0x03;
  EXPECT_FALSE(pad.decode(fingers));
  EXPECT_FALSE(pad.decode(Report{0x02, 0xe0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_FALSE(pad.decode(Report{0x03, 0, 0x85, 1, 6, 0, 0, 0, 0}));
  EXPECT_FALSE(pad.decode({}));
}

TEST(WacomPadDecoder, StripsOfIntuos3AndCintiq) {
  auto pad = pad_of(0x00b2);
  ASSERT_TRUE(pad.decode(Report{0x0c, 0x01, 0x80, 0x1f, 0x02, 0x11, 0x12, 0, 0, 0}));
  EXPECT_EQ(pad.sample().strip[0], 0x180);
  EXPECT_EQ(pad.sample().strip[1], 0x1f02);
  EXPECT_EQ(held(pad), "BTN_0+BTN_5");
  auto wide = pad_of(0x00c6);
  ASSERT_TRUE(wide.decode(Report{0x0c, 0, 0, 0, 0, 0x11, 0x12, 0, 0, 0}));
  EXPECT_EQ(held(wide), "BTN_0+BTN_5+BTN_8+BTN_9");
  auto small = pad_of(0x00b0);
  EXPECT_EQ(small.features().strips, 1u);
  ASSERT_TRUE(small.decode(Report{0x0c, 0, 1, 0, 1, 0xff, 0xff, 0, 0, 0}));
  EXPECT_EQ(held(small), "BTN_0+BTN_1+BTN_2+BTN_3");
  EXPECT_EQ(small.sample().strip[1], 0);
}

TEST(WacomPadDecoder, TheKeysBesideThePictureOfABigCintiq) {
  auto pad = pad_of(0x00f4);
  ASSERT_TRUE(pad.decode(Report{0x0c, 0x80, 0xc7, 0x04, 0xe1, 0, 0x02, 0, 0x04, 0}));
  EXPECT_EQ(held(pad), "KEY_PROG1+KEY_PROG2+KEY_PROG3+BTN_1+BTN_A+0x166+KEY_BUTTONCONFIG+KEY_ONSCREEN_KEYBOARD");
  EXPECT_TRUE(pad.sample().ring_touched[0]);
  EXPECT_EQ(pad.sample().ring[0], 0);
  EXPECT_EQ(pad.sample().ring[1], 0x47);
  EXPECT_EQ(pad.sample().mode[0], 1);
  EXPECT_EQ(pad.sample().mode[1], 2);
  // With fingers on it, the wrench's place turns them off instead.
  auto touch = pad_of(0x00f8);
  touch.decode(Report{0x0c, 0, 0, 0, 0x01, 0, 0, 0, 0, 0});
  EXPECT_EQ(held(touch), "KEY_PROG1");
}

TEST(WacomPadDecoder, EachStripOfTheCintiq21ux2HasItsModeKey) {
  auto pad = pad_of(0x00cc);
  ASSERT_TRUE(pad.decode(Report{0x0c, 0, 0, 0, 0, 0x01, 0, 0, 0, 0}));
  EXPECT_EQ(held(pad), "BTN_0");
  EXPECT_EQ(pad.sample().mode[0], 1);
  EXPECT_EQ(pad.sample().mode[1], 0);
  ASSERT_TRUE(pad.decode(Report{0x0c, 0, 0, 0, 0, 0, 0, 0x01, 0x80, 0}));
  EXPECT_EQ(held(pad), "BTN_9+BTN_BASE2");
  EXPECT_EQ(pad.sample().mode[1], 1);
}

TEST(WacomPadDecoder, KeysInThePensReport) {
  auto pad = pad_of(0x0017);
  ASSERT_TRUE(pad.decode(Report{0x02, 0x00, 0, 0, 0, 0, 0, 0x48, 0x85}));
  EXPECT_EQ(held(pad), "BTN_RIGHT+BTN_BACK");
  EXPECT_EQ(pad.sample().ring[0], 5);
  EXPECT_TRUE(pad.decode(Report{0x02, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(held(pad), "-");
  EXPECT_FALSE(pad.decode(Report{0x02, 0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(WacomPadDecoder, WheelStepsAreThoseOfTheirReport) {
  auto pad = pad_of(0x0015);
  ASSERT_TRUE(pad.decode(Report{0x02, 0, 0, 0, 0, 0, 0, 0x90}));
  EXPECT_EQ(pad.sample().wheel[0], 2);
  EXPECT_EQ(held(pad), "BTN_FORWARD");
  ASSERT_TRUE(pad.decode(Report{0x02, 0, 0, 0, 0, 0, 0, 0x38}));
  EXPECT_EQ(pad.sample().wheel[0], -1);
  ASSERT_TRUE(pad.decode(Report{0x02, 0, 0, 0, 0, 0, 0, 0x00}));
  EXPECT_EQ(pad.sample().wheel[0], 0);
}

TEST(WacomPadDecoder, KeysAmongTheFingers) {
  auto pad = pad_of(0x00d1);
  Report two(20);
  two[0] = 0x02;
  two[1] = 0x09;
  ASSERT_TRUE(pad.decode(two));
  EXPECT_EQ(held(pad), "BTN_LEFT+BTN_RIGHT");
  auto consumer = pad_of(0x0302);
  Report many(64);
  many[0] = 0x02;
  many[1] = 2;
  many[2] = 3;
  many[10] = 128;
  many[11] = 0x0a;
  ASSERT_TRUE(consumer.decode(many));
  EXPECT_EQ(held(consumer), "BTN_LEFT+BTN_BACK");
  many[11] = 0x02;
  consumer.decode(many);
  EXPECT_EQ(held(consumer), "BTN_LEFT");
  many[1] = 1;
  EXPECT_FALSE(consumer.decode(many));
}

TEST(WacomPadDecoder, BluetoothTellsOfTheBattery) {
  auto pad = pad_of(0x0360, k_bus_bluetooth);
  Report report(361);
  report[0] = 0x80;
  report[281] = 0x40;
  report[282] = 0x01;
  report[284] = 0x80 | 77;
  report[285] = 0x80 | 71;
  ASSERT_TRUE(pad.decode(report));
  EXPECT_EQ(held(pad), "BTN_0+BTN_8");
  EXPECT_EQ(pad.sample().ring[0], 13);  // 0 + 3 of 16 parts of 72, rounded down
  EXPECT_EQ(pad.sample().mode[0], 1);
  EXPECT_EQ(pad.battery(), (Battery{77, true}));
  report.resize(285);
  EXPECT_FALSE(pad.decode(report));
}

TEST(WacomPadDecoder, AReportOverBluetoothHoldsSeveralOfThePad) {
  auto pad = pad_of(0x00bd, k_bus_bluetooth);
  Report report{0x03};
  for (const std::uint8_t key : {std::uint8_t{1}, std::uint8_t{2}}) {
    const Report part{0x0c, 0x80, 0, key, 0, 0, 0, 0, 0, 0};
    report.insert(report.end(), part.begin(), part.end());
  }
  report.push_back(0x0b);
  ASSERT_TRUE(pad.decode(report));
  EXPECT_EQ(held(pad), "BTN_2");
  EXPECT_EQ(pad.battery(), (Battery{45, true}));
  report.pop_back();
  EXPECT_FALSE(pad.decode(report));
}

TEST(WacomPadDecoder, ARemoteSaysItsModeItself) {
  auto pad = pad_of(0x0331);
  Report report{0x11, 0, 0, 1, 2, 3, 0, 50, 0, 0x80, 0x01, 0x82, 0x81};
  ASSERT_TRUE(pad.decode(report));
  EXPECT_EQ(held(pad), "BTN_7+BTN_8+BTN_BASE2");
  EXPECT_EQ(pad.sample().ring[0], 0);
  EXPECT_TRUE(pad.sample().ring_touched[0]);
  EXPECT_EQ(pad.sample().mode[0], 2);
  EXPECT_EQ(pad.battery(), (Battery{50, false}));
}

}  // namespace
}  // namespace penpose::decode
