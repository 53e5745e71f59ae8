#include "firmware_io/device/list/tablet_watch.h"

#include <gtest/gtest.h>

namespace penpose::device {
namespace {

LiveTablet tablet(const std::string& port, Access access = Access::allowed) {
  LiveTablet made;
  made.interface.parent = "/sys/devices/" + port;
  made.interface.usb_node = "/dev/bus/usb/001/" + port;
  made.interface.usb_name = port + ":1.0";
  made.transport = Transport::libusb;
  made.access = access;
  return made;
}

TEST(TabletChanges, WhatStaysIsNoChange) {
  EXPECT_TRUE(changes_between({tablet("1-1"), tablet("1-2")}, {tablet("1-2"), tablet("1-1")}).empty());
  EXPECT_TRUE(changes_between({}, {}).empty());
}

TEST(TabletChanges, ArrivalAndLeavingAreTold) {
  const auto changes = changes_between({tablet("1-1"), tablet("1-2")}, {tablet("1-2"), tablet("1-3")});
  ASSERT_EQ(changes.arrived.size(), 1u);
  EXPECT_EQ(changes.arrived[0].path(), "usb:1-3:1.0");
  ASSERT_EQ(changes.left.size(), 1u);
  EXPECT_EQ(changes.left[0].path(), "usb:1-1:1.0");
}

TEST(TabletChanges, PluggedInAnewInTheSamePlaceIsAnotherOne) {
  LiveTablet again = tablet("1-1");
  again.interface.usb_node = "/dev/bus/usb/001/009";
  const auto changes = changes_between({tablet("1-1")}, {again});
  EXPECT_EQ(changes.arrived.size(), 1u);
  EXPECT_EQ(changes.left.size(), 1u);
}

TEST(TabletChanges, PermissionThatCameIsAnArrival) {
  EXPECT_EQ(changes_between({tablet("1-1", Access::denied)}, {tablet("1-1")}).arrived.size(), 1u);
}

TEST(TabletChanges, TakenFromTheDriverAndGivenBackItStays) {
  EXPECT_TRUE(changes_between({tablet("1-1")}, {tablet("1-1", Access::busy)}).empty());
  EXPECT_TRUE(changes_between({tablet("1-1", Access::busy)}, {tablet("1-1")}).empty());
}

TEST(TabletChanges, ANodeThatIsBoundAnewIsAnotherOne) {
  LiveTablet before = tablet("1-1");
  before.transport = Transport::hidraw;
  before.interface.hidraw_node = "/dev/hidraw0";
  before.interface.hid_name = "0003:056A:00B8.0001";
  LiveTablet after = before;
  EXPECT_TRUE(changes_between({before}, {after}).empty());
  after.interface.hid_name = "0003:056A:00B8.0002";
  EXPECT_FALSE(changes_between({before}, {after}).empty());
}

TEST(TabletChanges, AnEventDeviceIsReplacedByAnInterfaceOfTheSameTabletAlone) {
  LiveTablet event = tablet("1-1");
  event.interface.event_node = "/dev/input/event4";
  event.transport = Transport::event;
  EXPECT_TRUE(changes_between({event}, {tablet("1-1")}).replaced(event));
  EXPECT_FALSE(changes_between({event}, {}).replaced(event)) << "it was unplugged";
  EXPECT_FALSE(changes_between({event}, {tablet("1-2")}).replaced(event)) << "another tablet came";
  EXPECT_FALSE(changes_between({tablet("1-1", Access::denied)}, {tablet("1-1")}).replaced(tablet("1-1")));
}

/// As it is in the end, read beside its driver.
LiveTablet at_rest(const std::string& port) {
  LiveTablet made = tablet(port);
  made.transport = Transport::hidraw;
  made.interface.hidraw_node = "/dev/hidraw0";
  made.interface.hid_name = "0003:056A:00B8.0001";
  return made;
}

TEST(Settling, WhileItsDriverIsStillToComeATabletIsHeldBack) {
  Settling settling;
  EXPECT_TRUE(settling.settle({}, {tablet("1-1")}, 1000).empty());
  EXPECT_GT(settling.until_us().value_or(0), 1000);
  const auto told = settling.settle({}, {at_rest("1-1")}, 90'000);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].path(), "/dev/hidraw0");
  EXPECT_FALSE(settling.until_us());
}

TEST(Settling, OneThatStaysWithoutADriverIsTold) {
  Settling settling;
  EXPECT_TRUE(settling.settle({}, {tablet("1-1")}, 0).empty());
  const auto until = settling.until_us();
  ASSERT_TRUE(until);
  EXPECT_TRUE(settling.settle({}, {tablet("1-1")}, *until - 1).empty());
  EXPECT_EQ(settling.until_us(), until) << "an event in between makes it no longer";
  EXPECT_EQ(settling.settle({}, {tablet("1-1")}, *until).size(), 1u);
  EXPECT_FALSE(settling.until_us());
  EXPECT_EQ(settling.settle({tablet("1-1")}, {tablet("1-1")}, *until + 1).size(), 1u);
}

TEST(Settling, OneThatIsBeingTakenDownLeavesOnce) {
  Settling settling;
  const std::vector<LiveTablet> known{at_rest("1-1")};
  LiveTablet half_gone = at_rest("1-1");
  half_gone.access = Access::absent;
  EXPECT_TRUE(changes_between(known, settling.settle(known, {half_gone}, 0)).empty());
  EXPECT_TRUE(changes_between(known, settling.settle(known, {tablet("1-1")}, 1000)).empty());
  EXPECT_EQ(changes_between(known, settling.settle(known, {}, 2000)).left.size(), 1u);
  EXPECT_FALSE(settling.until_us());
}

TEST(Settling, OneThatAProgramHoldsIsAtRest) {
  Settling settling;
  EXPECT_EQ(settling.settle({}, {tablet("1-1", Access::busy)}, 0).size(), 1u);
}

}  // namespace
}  // namespace penpose::device
