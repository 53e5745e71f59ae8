#include "firmware_io/decode/described/described_pad_decoder.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/decode/sample/pad_events.h"
#include "tests/support/hands/hand_descriptors.h"

// The codes that are expected here are worked out by hand from Linux 6.1, drivers/hid/hid-input.c.

namespace penpose::decode {
namespace {

using tests::Report;

std::unique_ptr<PadDecoder> pad_of(const Report& descriptor) {
  DeviceIdentity device;
  device.bus = k_bus_usb;
  device.vendor = 0xfff0;
  device.product = 1;
  device.report_descriptor = descriptor;
  return make_hand_decoders(device).pad;
}

/// What is held after a report of the pad.
std::string held(PadDecoder& pad, Report report) {
  EXPECT_TRUE(pad.decode(report));
  return key_names(pad.sample().keys);
}

Report uclogic(std::uint8_t id, std::uint8_t first, std::uint8_t fourth, std::uint8_t fifth = 0) {
  return {id, first, 1, 1, fourth, fifth, 0, 0, 0, 0, 0, 0};
}

/// A Keypad, or another application, with these items as report 6.
Report pad_with(const Report& items, std::uint8_t page = 0x01, std::uint8_t application = 0x07) {
  Report all{0x05, page, 0x09, application, 0xa1, 0x01, 0x85, 0x06};
  tests::append(all, items);
  all.push_back(0xc0);
  return all;
}

TEST(DescribedPad, KeysOfAKeypadAreCountedFromTheFirst) {
  const auto pad = pad_of(tests::uclogic_pad_descriptor());
  ASSERT_TRUE(pad);
  EXPECT_EQ(held(*pad, uclogic(0xf7, 0xe0, 0x01)), "BTN_0");
  EXPECT_EQ(held(*pad, uclogic(0xf7, 0xe0, 0x80, 0x02)), "BTN_7+BTN_9");
  EXPECT_EQ(held(*pad, uclogic(0xf7, 0xe0, 0, 0x14)), "BTN_A+BTN_C") << "those beyond ten are a game pad's";
  EXPECT_EQ(held(*pad, uclogic(0xf7, 0xe1, 0)), "BTN_STYLUS");
  EXPECT_EQ(held(*pad, uclogic(0xf7, 0xe0, 0)), "-");
  EXPECT_EQ(pad->features().keys, numbered_keys(~std::uint64_t{0}, 13)) << "no pad has the pen's button";
}

TEST(DescribedPad, AKeyThatIsDescribedTwiceIsTheFirst) {
  const auto pad = pad_of(tests::uclogic_pad_descriptor());
  ASSERT_TRUE(pad);
  EXPECT_EQ(held(*pad, uclogic(0xf7, 0xe0, 0x01)), "BTN_0");
  EXPECT_EQ(held(*pad, uclogic(0xf8, 0xf0, 0)), "BTN_0") << "button 1 of the ring's report says nothing";
  EXPECT_EQ(held(*pad, uclogic(0xf7, 0xe0, 0)), "-");
  EXPECT_EQ(held(*pad, uclogic(0xf9, 0xf1, 0)), "-");
}

TEST(DescribedPad, ARingGivesPlacesAndSaysWhetherAFingerIsThere) {
  const auto pad = pad_of(tests::uclogic_pad_descriptor());
  ASSERT_TRUE(pad);
  EXPECT_EQ(pad->features().rings, 1U);
  EXPECT_EQ(pad->features().ring_maximum, 11);
  PadEvents events(pad->features());
  std::vector<PadEvent> out;
  const auto turn = [&](std::uint8_t finger, std::uint8_t place) {
    pad->decode(uclogic(0xf8, 0xf0, finger, place));
    out.clear();
    events.add(pad->sample(), 0, out);
    return pad->sample().ring[0];
  };
  EXPECT_EQ(turn(15, 0), 0);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].kind, PadEventKind::touched) << "at the first place";
  EXPECT_EQ(turn(15, 2), 2);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].steps, 2 * k_notch);
  EXPECT_EQ(turn(15, 14), 11) << "beyond the range is its end";
  EXPECT_EQ(turn(0, 0), 0);
  EXPECT_EQ(out[0].kind, PadEventKind::let_go);
}

TEST(DescribedPad, StepsOfADialAreThoseOfTheReport) {
  const auto pad = pad_of(tests::uclogic_pad_descriptor());
  ASSERT_TRUE(pad);
  EXPECT_EQ(pad->features().wheels, 1U);
  PadEvents events(pad->features());
  std::vector<PadEvent> out;
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(pad->decode(uclogic(0xf9, 0xf0, 15, 0xff)));
    EXPECT_EQ(pad->sample().wheel[0], -1) << i;
    events.add(pad->sample(), 0, out);
  }
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[1].steps, -k_notch) << "against the clock";
  EXPECT_TRUE(pad->decode(uclogic(0xf7, 0xe0, 0)));
  EXPECT_EQ(pad->sample().wheel[0], 0);
}

/// As an HID-BPF program describes it: eight keys in the first byte, then what makes desktops take it for a pad.
TEST(DescribedPad, KeysInAnApplicationOfTheirOwn) {
  Report items = tests::input(tests::buttons(8), 1, 8);
  tests::append(items, tests::input({0xd0044}, 1, 1));
  tests::append(items, tests::padding(7));
  tests::append(items, tests::steps(0x10038));
  tests::append(items, tests::steps(0xc0238));
  const auto pad = pad_of(pad_with(items, 0x0d, 0x39));
  ASSERT_TRUE(pad);
  EXPECT_EQ(held(*pad, {6, 0x81, 0, 0, 0}), "BTN_0+BTN_7");
  EXPECT_TRUE(pad->decode(Report{6, 0x81, 0, 1, 0xff}));
  EXPECT_EQ(pad->sample().wheel, (std::array<std::int32_t, 2>{1, -1}));
  EXPECT_EQ(pad->features().wheels, 2U);
}

TEST(DescribedPad, MoreKeysThanLinuxHasNumbersForGoOnWithTheCodesBehind) {
  const auto pad = pad_of(pad_with(tests::input(tests::buttons(24), 1, 24)));
  ASSERT_TRUE(pad);
  EXPECT_EQ(held(*pad, {6, 0, 0xfc, 0x0f}),
            "0x10a+0x10b+0x10c+0x10d+0x10e+0x10f+BTN_LEFT+BTN_RIGHT+BTN_MIDDLE+BTN_SIDE");
  EXPECT_EQ(pad->features().keys.count(), 24U);
  const auto far = pad_of(pad_with(tests::input({0x90001, 0x90031, 0x90044, 0x9ffff}, 1, 4)));
  ASSERT_TRUE(far);
  EXPECT_EQ(held(*far, {6, 0x0f}), "BTN_0+BTN_A+0x143") << "the last has no code";
}

TEST(DescribedPad, TheLastUsageOfAFieldIsNotAKeyAgain) {
  const auto pad = pad_of(pad_with(tests::input(tests::buttons(3), 1, 8)));
  ASSERT_TRUE(pad);
  EXPECT_EQ(held(*pad, {6, 0xf8}), "-");
  EXPECT_EQ(held(*pad, {6, 0x04}), "BTN_2");
}

TEST(DescribedPad, KeysMayBeNamedByNumber) {
  // Two selectors of eight bits, which name one of four keys each; 0 is none.
  Report items{0x05, 0x09, 0x19, 0x01, 0x29, 0x04, 0x15, 0x01, 0x25, 0x04, 0x75, 0x08, 0x95, 0x02, 0x81, 0x00};
  const auto pad = pad_of(pad_with(items));
  ASSERT_TRUE(pad);
  EXPECT_EQ(held(*pad, {6, 4, 2}), "BTN_1+BTN_3");
  EXPECT_EQ(held(*pad, {6, 0, 2}), "BTN_1");
  EXPECT_EQ(held(*pad, {6, 5, 0xff}), "-");
}

TEST(DescribedPad, ButtonsOfOtherCollectionsHaveOtherCodes) {
  const auto with = [](std::uint8_t physical) {
    Report items{0x05, 0x01, 0x09, physical, 0xa1, 0x00};
    tests::append(items, tests::input(tests::buttons(2), 1, 8));
    items.push_back(0xc0);
    const auto pad = pad_of(pad_with(items));
    return pad ? held(*pad, {6, 3}) : "none";
  };
  EXPECT_EQ(with(0x02), "BTN_LEFT+BTN_RIGHT");
  EXPECT_EQ(with(0x04), "0x120+0x121");
  EXPECT_EQ(with(0x05), "BTN_A+BTN_B");
  EXPECT_EQ(with(0x06), "BTN_0+BTN_1");
}

TEST(DescribedPad, WhatLinuxDoesNotKnowIsTheFirstButton) {
  Report items = tests::input({0xd0001}, 1, 1);
  tests::append(items, tests::input(tests::buttons(2), 1, 2));
  tests::append(items, tests::padding(5));
  const auto pad = pad_of(pad_with(items));
  ASSERT_TRUE(pad);
  EXPECT_EQ(held(*pad, {6, 0x01}), "BTN_0");
  EXPECT_EQ(held(*pad, {6, 0x06}), "BTN_1") << "and then button 1 is nothing";
}

TEST(DescribedPad, StripsSecondRingsAndDials) {
  Report items = tests::input(tests::buttons(8), 1, 8);
  tests::append(items, tests::input({0x10033}, 8, 1, 8));
  tests::append(items, tests::input({0x10034}, 8, 1, 8));
  tests::append(items, tests::input({0x10038}, 8, 1, 71));
  tests::append(items, tests::input({0x10036}, 8, 1, 71));
  tests::append(items, tests::steps(0x10037));
  const auto pad = pad_of(pad_with(items));
  ASSERT_TRUE(pad);
  EXPECT_TRUE(pad->decode(Report{6, 0, 3, 8, 70, 0, 2}));
  EXPECT_EQ(pad->sample().strip, (std::array<std::int32_t, 2>{3, 8}));
  EXPECT_EQ(pad->sample().ring, (std::array<std::int32_t, 2>{70, 0}));
  EXPECT_EQ(pad->sample().ring_touched, (std::array<bool, 2>{true, false}));
  EXPECT_EQ(pad->sample().wheel[0], 0) << "Linux's two wheels do not turn with a dial";
  EXPECT_EQ(pad->sample().fine_wheel[0], k_notch) << "at most a step, as described";
  EXPECT_EQ(pad->features().wheels, 1U);
}

TEST(DescribedPad, AFingerAtTheFirstPlaceOfAStripIsThere) {
  Report items = tests::input({0xdffff}, 8, 1, 255);
  tests::append(items, tests::input({0x10033}, 8, 1, 7));
  Report keys = tests::function_keys(0x06);
  tests::append(keys, items);
  tests::append(keys, {0xc0, 0xc0});
  const auto pad = pad_of(keys);
  ASSERT_TRUE(pad);
  PadEvents events(pad->features());
  std::vector<PadEvent> out;
  for (const auto& report : {Report{6, 15, 0}, Report{6, 15, 2}, Report{6, 15, 0}, Report{6, 0, 0}}) {
    EXPECT_TRUE(pad->decode(report));
    events.add(pad->sample(), 0, out);
  }
  ASSERT_EQ(out.size(), 4U);
  EXPECT_EQ(out[0].kind, PadEventKind::touched);
  EXPECT_EQ(out[1].steps, 2 * k_notch);
  EXPECT_EQ(out[2].steps, -2 * k_notch);
  EXPECT_EQ(out[3].kind, PadEventKind::let_go);
}

TEST(DescribedPad, WhatIsNoPadIsNone) {
  EXPECT_FALSE(pad_of(pad_with(tests::input({0x70059, 0x7005a}, 1, 8)))) << "numbers of a keyboard";
  EXPECT_FALSE(pad_of(pad_with(tests::input(tests::buttons(8), 1, 8), 0x01, 0x05))) << "a game pad";
  EXPECT_FALSE(pad_of(pad_with(tests::input(tests::buttons(8), 1, 8), 0x01, 0x02))) << "a mouse";
  EXPECT_FALSE(pad_of(pad_with(tests::input({0xd0001}, 1, 8)))) << "nothing known";
  EXPECT_FALSE(pad_of(pad_with(tests::input(tests::buttons(8), 1, 8, 1, 0x03)))) << "constant";
  EXPECT_FALSE(pad_of(tests::ink_descriptor()));
  EXPECT_FALSE(pad_of({}));
}

TEST(DescribedPad, OtherReportsAndSuchAsWereCutOffAreNotThePads) {
  const auto pad = pad_of(tests::uclogic_pad_descriptor());
  ASSERT_TRUE(pad);
  EXPECT_EQ(held(*pad, uclogic(0xf7, 0xe0, 0x01)), "BTN_0");
  EXPECT_FALSE(pad->decode(Report{0xf7, 0xe0, 1, 1, 0}));
  EXPECT_FALSE(pad->decode(Report{0x08, 0xe0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_FALSE(pad->decode(Report{}));
  EXPECT_EQ(key_names(pad->sample().keys), "BTN_0");
  pad->reset();
  EXPECT_EQ(pad->sample(), PadSample{});
}

TEST(DescribedPad, SaysTheChargeOfItsBatteryToo) {
  // Also in a collection of a pen, where some descriptors have it for Linux's sake.
  for (const bool as_pens : {false, true}) {
    Report items = tests::input(tests::buttons(8), 1, 8);
    if (as_pens) tests::append(items, {0x05, 0x0d, 0x09, 0x20, 0xa1, 0x00});
    tests::append(items, tests::input({0x850065}, 8, 1, 200));
    if (as_pens) items.push_back(0xc0);
    const auto pad = pad_of(pad_with(items));
    ASSERT_TRUE(pad);
    EXPECT_EQ(held(*pad, {6, 1, 100}), "BTN_0");
    EXPECT_EQ(pad->battery().percent, 50);
  }
}

/// A H640P, whose firmware says what it is, with and without the kernel's driver.
TEST(DescribedPad, ATabletOfTheTableHasItsOwnKeysInBothForms) {
  DeviceIdentity device;
  device.bus = k_bus_usb;
  device.vendor = 0x256c;
  device.product = 0x0064;
  device.strings[201] = "HUION_T203_200101";
  device.report_descriptor = tests::uclogic_pad_descriptor();
  const auto pad = make_hand_decoders(device).pad;
  ASSERT_TRUE(pad);
  EXPECT_EQ(pad->features().keys, numbered_keys(~std::uint64_t{0}, 6));
  EXPECT_EQ(held(*pad, uclogic(0xf7, 0xe0, 0x20)), "BTN_5") << "as the driver rewrites it";
  EXPECT_EQ(held(*pad, uclogic(0x08, 0xe0, 0x10)), "BTN_4") << "as the tablet sends it";
  pad->reset();
  EXPECT_EQ(pad->sample(), PadSample{});
  device.strings.clear();
  EXPECT_EQ(make_hand_decoders(device).pad->features().keys.count(), 13U) << "which one it is is not known";
}

}  // namespace
}  // namespace penpose::decode
