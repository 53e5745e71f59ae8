#include "firmware_io/device/tablet_watch.h"

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

}  // namespace
}  // namespace penpose::device
