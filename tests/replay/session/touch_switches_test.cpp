#include "replay/session/touch_switches.h"

#include <gtest/gtest.h>

#include "replay/session/hand_input.h"
#include "tests/support/hands/hand_descriptors.h"

namespace penpose::replay {
namespace {

constexpr std::uint16_t k_wacom = 0x056a;
constexpr std::uint16_t k_described = 0xfff0;  // in no table

decode::DeviceIdentity part(std::string unit, tests::Report descriptor, std::uint16_t product = k_described) {
  decode::DeviceIdentity identity;
  identity.vendor = k_wacom;
  identity.product = product;
  identity.unit = std::move(unit);
  identity.report_descriptor = std::move(descriptor);
  return identity;
}
decode::DeviceIdentity keys(const std::string& unit, std::uint16_t product = k_described) {
  return part(unit, tests::wacom_pad_descriptor(), product);
}
decode::DeviceIdentity fingers(const std::string& unit, std::uint16_t product = k_described) {
  return part(unit, tests::touch_descriptor(2), product);
}

TEST(TouchSwitches, ThePartsOfATabletShareOneAndThoseOfItsTwinAnother) {
  TouchSwitches switches;
  const auto first = switches.join(1, keys("usb-1"));
  const auto twin = switches.join(2, keys("usb-2"));
  EXPECT_EQ(switches.join(3, fingers("usb-1")), first);
  EXPECT_EQ(switches.join(4, fingers("usb-2")), twin);
  EXPECT_NE(first, twin);
}

TEST(TouchSwitches, APenAndItsFingersBehindOneHubShareOne) {
  TouchSwitches switches;
  const auto pen = switches.join(1, part("usb-0000:00:14.0-2.1", tests::ink_descriptor(), 0xfff1));
  EXPECT_EQ(switches.join(2, fingers("usb-0000:00:14.0-2.2", 0xfff2)), pen);
  EXPECT_NE(switches.join(3, fingers("usb-0000:00:14.0-2.3", 0xfff3)), pen) << "it has its fingers";
  EXPECT_NE(switches.join(4, fingers("usb-0000:00:14.0-3.2", 0xfff2)), pen) << "at another hub";
}

TEST(TouchSwitches, WhatIsPluggedIntoTheMachineItselfIsAtNoHub) {
  TouchSwitches switches;
  const auto pen = switches.join(1, part("usb-0000:00:14.0-2", tests::ink_descriptor(), 0xfff1));
  EXPECT_NE(switches.join(2, fingers("usb-0000:00:14.0-3", 0xfff2)), pen);
}

TEST(TouchSwitches, WhereNothingIsKnownOfTheirPlacesAllOfAMakerShareOne) {
  TouchSwitches switches;
  EXPECT_EQ(switches.join(1, keys("")), switches.join(2, fingers("", 0xfff2)));
}

TEST(TouchSwitches, APlaceThatAllHaveLeftBeginsAnew) {
  TouchSwitches switches;
  const auto first = switches.join(1, keys("usb-1"));
  switches.leave(1);
  EXPECT_NE(switches.join(1, keys("usb-1")), first);
}

/// The slide that turns touch on (bit 1 of its second byte), and a finger.
const tests::Report k_on{0x11, 0, 0x02, 0, 0};
tests::Report finger() { return tests::touch_report({{5, 1, 10, 20}, {0, 0, 0, 0}}, 1); }

TEST(TouchSwitches, OneTabletsSlideLeavesTheFingersOfAnotherAsTheyAre) {
  HandInput hands;
  hands.connect(1, keys("usb-1"));
  hands.connect(2, fingers("usb-1"));
  hands.connect(3, keys("usb-2"));
  hands.connect(4, fingers("usb-2"));
  (void)hands.report(1, 1000, k_on);
  (void)hands.report(2, 2000, finger());
  (void)hands.report(4, 2000, finger());
  EXPECT_EQ(hands.fingers(2).size(), 1U);
  EXPECT_TRUE(hands.fingers(4).empty()) << "its own slide was not told of";
}

TEST(TouchSwitches, UnpluggedAndPluggedInAgainTheSlideIsNotKnown) {
  HandInput hands;
  hands.connect(1, keys("usb-1"));
  hands.connect(2, fingers("usb-1"));
  (void)hands.report(1, 1000, k_on);
  (void)hands.disconnect(1, 2000);
  (void)hands.disconnect(2, 2000);
  hands.connect(1, keys("usb-1"));
  hands.connect(2, fingers("usb-1"));
  (void)hands.report(2, 3000, finger());
  EXPECT_TRUE(hands.fingers(2).empty());
  (void)hands.report(1, 4000, k_on);
  (void)hands.report(2, 5000, finger());
  EXPECT_EQ(hands.fingers(2).size(), 1U);
}

}  // namespace
}  // namespace penpose::replay
