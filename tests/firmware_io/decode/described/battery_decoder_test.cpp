#include "firmware_io/decode/described/battery_decoder.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/hand_factory.h"
#include "tests/support/hands/hand_descriptors.h"

namespace penpose::decode {
namespace {

using tests::Report;

/// A control of report 5 with this usage, from 0 to `maximum`, in a collection of its own; `inside` a pen's.
Report battery_descriptor(std::uint32_t usage, std::uint32_t maximum, bool inside = false) {
  Report items{0x05, 0x0d, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x05};
  if (inside) tests::append(items, {0x05, 0x0d, 0x09, 0x20, 0xa1, 0x00});
  tests::append(items, tests::padding(8));
  tests::append(items, tests::input({usage}, 8, 1, maximum));
  if (inside) items.push_back(0xc0);
  items.push_back(0xc0);
  return items;
}

DeviceIdentity device_of(Report descriptor, std::uint16_t vendor = 0x28bd) {
  DeviceIdentity device;
  device.bus = k_bus_bluetooth;
  device.vendor = vendor;
  device.product = 0xfff0;
  device.report_descriptor = std::move(descriptor);
  return device;
}

TEST(BatteryDecoder, ReadsTheChargeThatIsDescribed) {
  for (const std::uint32_t usage : {0x060020U, 0x850064U, 0x850065U}) {
    const auto hand = make_hand_decoders(device_of(battery_descriptor(usage, 200)));
    ASSERT_TRUE(hand.pad);
    EXPECT_FALSE(hand.pad->features().any());
    EXPECT_EQ(hand.pad->battery().percent, -1) << "nothing was said";
    EXPECT_FALSE(hand.pad->decode(Report{5, 0, 90}));
    EXPECT_EQ(hand.pad->battery().percent, 45);
    hand.pad->decode(Report{5, 0, 201});
    EXPECT_EQ(hand.pad->battery().percent, 45) << "beyond its range it is no value";
    hand.pad->decode(Report{6, 0, 20});
    hand.pad->decode(Report{5, 0});
    hand.pad->decode(Report{});
    EXPECT_EQ(hand.pad->battery().percent, 45) << "other reports, and such as were cut off";
    hand.pad->reset();
    EXPECT_EQ(hand.pad->battery().percent, -1);
  }
}

TEST(BatteryDecoder, ThatOfAPenIsNotTheTablets) {
  EXPECT_FALSE(make_hand_decoders(device_of(battery_descriptor(0x060020, 100, true))).pad);
  EXPECT_FALSE(make_hand_decoders(device_of(battery_descriptor(0x060021, 100))).pad) << "another control";
}

/// The report that the wireless tablets of XP-Pen send by themselves. Source: Linux, hid-uclogic-rdesc.c (UGEE v2).
TEST(BatteryDecoder, AVendorsProtocolMayTellOfIt) {
  for (const char* name : {"xp_pen", "xp_pen_offset_pressure"}) {
    const auto hand = make_protocol_hand_decoders(name);
    ASSERT_TRUE(hand.pad) << name;
    EXPECT_FALSE(hand.pad->decode(Report{0x02, 0xf2, 0x01, 0x80, 0, 0, 0, 0, 0, 0, 0, 0})) << "of no key";
    EXPECT_EQ(hand.pad->battery().percent, 50) << name;
    EXPECT_TRUE(hand.pad->sample().keys.empty());
    EXPECT_TRUE(hand.pad->decode(Report{0x02, 0xf0, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(hand.pad->battery().percent, 50) << "and stays as it was";
  }
}

}  // namespace
}  // namespace penpose::decode
