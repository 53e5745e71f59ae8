#include "firmware_io/device/list/event_list.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>
#include <string>
#include <unistd.h>

#include "firmware_io/device/list/permission.h"
#include "firmware_io/device/live_tablet.h"

namespace penpose::device {
namespace {

/// Writes what /sys says of an input device.
class SysFolder {
 public:
  SysFolder() : path_(testing::TempDir() + "/penpose_event_list_" + std::to_string(::getpid())) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_ + "/capabilities");
    std::filesystem::create_directories(path_ + "/id");
  }
  ~SysFolder() { std::filesystem::remove_all(path_); }
  SysFolder(const SysFolder&) = delete;
  SysFolder& operator=(const SysFolder&) = delete;

  void put(const std::string& name, const std::string& text) const {
    std::ofstream(path_ + "/" + name) << text << '\n';
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

TEST(EventList, ReadsWhatTheKernelSaysWithoutOpeningTheDevice) {
  const SysFolder sys;
  // reMarkable's digitizer; parts of 64 bits, the most significant first.
  if (sizeof(long) == 8) {
    sys.put("capabilities/key", "1c03 0 0 0 0 0");
    sys.put("capabilities/abs", "f000003");
  } else {
    sys.put("capabilities/key", "1c03 0 0 0 0 0 0 0 0 0 0");
    sys.put("capabilities/abs", "f000003");
  }
  sys.put("capabilities/rel", "0");
  sys.put("capabilities/msc", "1");
  sys.put("properties", "2");
  sys.put("name", "Wacom I2C Digitizer");
  sys.put("phys", "");
  sys.put("id/bustype", "0018");
  sys.put("id/vendor", "056a");
  sys.put("id/product", "0000");
  const auto facts = read_event_facts(sys.path());
  EXPECT_TRUE(event::has_pen(facts));
  EXPECT_EQ(facts.keys, (std::set<std::uint16_t>{BTN_TOOL_PEN, BTN_TOOL_RUBBER, BTN_TOUCH, BTN_STYLUS, BTN_STYLUS2}));
  EXPECT_TRUE(facts.has_abs(ABS_X) && facts.has_abs(ABS_PRESSURE) && facts.has_abs(ABS_TILT_Y));
  EXPECT_FALSE(facts.has_abs(ABS_MISC));
  EXPECT_EQ(facts.name, "Wacom I2C Digitizer");
  EXPECT_EQ(facts.bus, 0x18);
  EXPECT_EQ(facts.vendor, 0x056a);
  EXPECT_TRUE(facts.mscs.contains(MSC_SERIAL));
  EXPECT_TRUE(facts.properties.contains(INPUT_PROP_DIRECT));
}

TEST(EventList, DamagedOrMissingFactsAreNoTablet) {
  const SysFolder sys;
  EXPECT_FALSE(event::has_pen(read_event_facts(sys.path())));
  sys.put("capabilities/key", "zz 123456789012345678901 \x01");
  sys.put("capabilities/abs", "ffffffffffffffff ffffffffffffffff ffffffffffffffff");
  EXPECT_FALSE(event::has_pen(read_event_facts(sys.path())));
  EXPECT_TRUE(list_event_devices(sys.path()).empty());
}

LiveTablet made(const std::string& parent, Transport transport, Access access, Carries carries = Carries::pen) {
  LiveTablet tablet;
  tablet.interface.parent = parent;
  tablet.transport = transport;
  (transport == Transport::event ? tablet.interface.event_node : tablet.interface.hidraw_node) = "/nowhere/" + parent;
  tablet.carries = carries;
  tablet.access = access;
  return tablet;
}

std::vector<Transport> ways(const std::vector<LiveTablet>& tablets) {
  std::vector<Transport> ways;
  for (const LiveTablet& tablet : tablets) ways.push_back(tablet.transport);
  return ways;
}

using Ways = std::vector<Transport>;
constexpr auto k_event = Transport::event;
constexpr auto k_hidraw = Transport::hidraw;

TEST(WithEventDevices, WhatCanBeReadThroughHidrawIsReadSo) {
  for (const Access access : {Access::allowed, Access::busy}) {
    const auto list = with_event_devices({made("a", k_hidraw, access)}, {}, {made("a", k_event, Access::allowed)});
    EXPECT_EQ(ways(list), Ways{k_hidraw});
  }
}

TEST(WithEventDevices, WhereHidrawIsClosedTheEventDevicesStandIn) {
  const auto list =
      with_event_devices({made("a", k_hidraw, Access::denied), made("b", k_hidraw, Access::allowed)}, {},
                         {made("a", k_event, Access::allowed), made("a", k_event, Access::allowed, Carries::pad)});
  EXPECT_EQ(ways(list), (Ways{k_hidraw, k_event, k_event}));
  EXPECT_EQ(list[0].interface.parent, "b");
  EXPECT_EQ(list[1].reason, "its HID interface cannot be opened");
}

TEST(WithEventDevices, WhereBothAreClosedItIsListedOnce) {
  const auto list = with_event_devices({made("a", k_hidraw, Access::denied)}, {}, {made("a", k_event, Access::denied)});
  EXPECT_EQ(ways(list), Ways{k_hidraw});
}

TEST(WithEventDevices, WhatOnlyTheKernelsDriverKnowsIsTaken) {
  HidInterface unknown;
  unknown.parent = "a";
  const auto list = with_event_devices({}, {unknown}, {made("a", k_event, Access::allowed)});
  ASSERT_EQ(ways(list), Ways{k_event});
  EXPECT_EQ(list[0].reason, "only the kernel's driver knows its reports");
}

TEST(WithEventDevices, AProgramsPenIsTakenWhereThereIsNoOther) {
  auto program = made("program", k_event, Access::allowed);
  program.interface.made_by_program = true;
  EXPECT_EQ(with_event_devices({}, {}, {program}).size(), 1U);
  EXPECT_EQ(ways(with_event_devices({made("a", k_hidraw, Access::allowed)}, {}, {program})), Ways{k_hidraw});
  const auto list = with_event_devices({}, {}, {program, made("b", k_event, Access::allowed)});
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].interface.parent, "b");
  EXPECT_EQ(with_event_devices({made("a", k_hidraw, Access::denied)}, {}, {program}).size(), 2U);
}

TEST(EventPermission, SaysWhatLetsIn) {
  const auto closed = made("a", k_event, Access::denied);
  const std::string said = missing(closed, "/opt/penpose");
  EXPECT_NE(said.find("You may not open it"), std::string::npos);
  EXPECT_EQ(missing(made("a", k_event, Access::allowed), "/opt/penpose"), "");
}

TEST(EventDevice, OneThatIsNoneIsRefusedInALine) {
  auto tablet = made("no_event_device", k_event, Access::allowed);
  const auto source = open_tablet(tablet);
  ASSERT_FALSE(source);
  EXPECT_NE(source.error().line().find("cannot be opened"), std::string::npos);
}

}  // namespace
}  // namespace penpose::device
