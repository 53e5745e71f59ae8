#include "firmware_io/device/list/interface_list.h"

#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "firmware_io/device/list/permission.h"
#include "firmware_io/device/list/tablet_watch.h"
#include "firmware_io/device/live_tablet.h"
#include "tests/support/hands/mock_system.h"
#include "tests/support/hands/pen_reports.h"
#include "ui/cli/parser/command_line.h"

// The preloaded library comes before the sanitizer's; that is known and does no harm.
extern "C" const char* __asan_default_options() { return "verify_asan_link_order=0"; }

namespace penpose::device {
namespace {

class MockDevices : public tests::MockSystem {
 protected:
  void plug_in_ink(const std::string& port = "1-1", const std::string& product = "0001") {
    plug_in(port, 0, tests::ink_descriptor(), "Ink pen", "hid-generic", "1B96", product);
  }
  static std::vector<LiveTablet> tablets() { return list_tablets(); }
  /// Runs in a child that is not root and gives its exit status.
  template <typename Body>
  static int as_nobody(const Body& body) {
    const pid_t child = ::fork();
    if (child == 0) {
      constexpr uid_t k_nobody = 65534;
      if (::geteuid() == 0 && ::setresuid(k_nobody, k_nobody, k_nobody) != 0) ::_exit(99);
      ::_exit(body());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 98;
  }
  /// Lets everybody see the nodes, as in a real /dev, and gives one of them that mode.
  void protect(const std::string& node, mode_t mode) const {
    std::string path = real("");
    ASSERT_EQ(::chmod(path.c_str(), 0755), 0);
    ASSERT_EQ(::chmod(real(node).c_str(), mode), 0);
  }
};

TEST_F(MockDevices, AnEmptySystemHasNoTablets) { EXPECT_TRUE(tablets().empty()); }

TEST_F(MockDevices, FactsOfAnInterfaceAreThoseOfTheSystem) {
  plug_in("1-2", 0, tests::ink_descriptor(), "Ink pen", "hid-multitouch", "1B96", "1000");
  const auto interfaces = list_interfaces();
  ASSERT_EQ(interfaces.size(), 1u);
  const HidInterface& found = interfaces.front();
  EXPECT_EQ(found.identity.bus, 3);
  EXPECT_EQ(found.identity.vendor, 0x1b96);
  EXPECT_EQ(found.identity.product, 0x1000);
  EXPECT_EQ(found.identity.name, "Ink pen");
  EXPECT_EQ(found.identity.interface_number, 0);
  EXPECT_EQ(found.identity.report_descriptor, tests::ink_descriptor());
  EXPECT_EQ(found.identity.input_report_length, 12);
  EXPECT_EQ(found.hidraw_node, "/dev/hidraw0");
  EXPECT_EQ(found.usb_node, "/dev/bus/usb/001/002");
  EXPECT_EQ(found.usb_name, "1-2:1.0");
  EXPECT_EQ(found.driver, "hid-multitouch");
  EXPECT_EQ(found.trace_path(), "usb-1-2/input0");
}

TEST_F(MockDevices, OfThreeInterfacesTheOneWithThePenIsListed) {
  const std::vector<std::uint8_t> mouse{0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x09, 0x30, 0x15, 0x81,
                                        0x25, 0x7f, 0x75, 0x08, 0x95, 0x01, 0x81, 0x06, 0xc0};
  const std::vector<std::uint8_t> keyboard{0x05, 0x01, 0x09, 0x06, 0xa1, 0x01, 0x05, 0x07, 0x19, 0xe0, 0x29, 0xe7,
                                           0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0xc0};
  plug_in("1-2", 0, mouse, "Three in one", "hid-generic", "1B96", "0002");
  plug_in("1-2", 1, keyboard, "Three in one", "hid-generic", "1B96", "0002");
  plug_in("1-2", 2, tests::ink_descriptor(), "Three in one", "hid-generic", "1B96", "0002");
  const auto list = tablets();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].interface.identity.interface_number, 2);
  EXPECT_EQ(list[0].path(), "/dev/hidraw2");
  EXPECT_EQ(list[0].access, Access::allowed);
  EXPECT_EQ(missing(list[0], "penpose"), "");
}

TEST_F(MockDevices, AnInterfaceThatAProgramHoldsIsSaidToBeBusy) {
  // Without a descriptor the table alone tells that it is a tablet.
  plug_in("1-3", 0, {}, "CTL-460", "", "056A", "00D4");
  const auto list = tablets();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].transport, Transport::libusb);
  EXPECT_EQ(list[0].path(), "usb:1-3:1.0");
  EXPECT_EQ(list[0].access, Access::busy);
  EXPECT_NE(missing(list[0], "penpose").find("close that program"), std::string::npos);
}

TEST_F(MockDevices, WithoutPermissionItSaysWhatMendsIt) {
  plug_in_ink();
  protect("/dev/hidraw0", 0);
  const int status = as_nobody([] {
    const auto list = tablets();
    if (list.size() != 1 || list[0].access != Access::denied) return 1;
    const std::string said = missing(list[0], "/opt/penpose");
    return said.find("run: sudo /opt/penpose devices --install-udev-rule") != std::string::npos ? 0 : 2;
  });
  EXPECT_EQ(status, 0);
}

TEST_F(MockDevices, WithoutPermissionNothingIsRecordedAndNoFileIsTouched) {
  plug_in_ink();
  protect("/dev/hidraw0", 0);
  const std::string path = testing::TempDir() + "/penpose_no_permission_" + std::to_string(::getpid()) + ".hid";
  ::unlink(path.c_str());
  const int status = as_nobody([&] {
    const char* const arguments[] = {"penpose", "record", "-o", path.c_str()};
    return cli::run(4, arguments);
  });
  EXPECT_EQ(status, 1);
  EXPECT_NE(::access(path.c_str(), F_OK), 0);
}

TEST_F(MockDevices, TheListIsOneJsonObject) {
  plug_in_ink();
  testing::internal::CaptureStdout();
  const char* const arguments[] = {"penpose", "devices", "--json"};
  EXPECT_EQ(cli::run(3, arguments), 0);
  const auto object = nlohmann::json::parse(testing::internal::GetCapturedStdout(), nullptr, false);
  ASSERT_TRUE(object.is_object());
  EXPECT_EQ(object["count"], 1);
  const auto& tablet = object["tablets"][0];
  EXPECT_EQ(tablet["path"], "/dev/hidraw0");
  EXPECT_EQ(tablet["method"], "descriptor");
  EXPECT_EQ(tablet["carries"], "pen");
  EXPECT_EQ(tablet["can_open"], true);
  EXPECT_TRUE(tablet["missing"].is_null());
}

TEST_F(MockDevices, ComingAndGoingIsSeen) {
  plug_in_ink();
  auto watch = TabletWatch::start();
  ASSERT_TRUE(watch);
  ASSERT_EQ(watch->tablets().size(), 1u);
  EXPECT_TRUE(watch->next(0).empty());

  plug_in_ink("1-2", "0002");
  tell_added(1);
  TabletChanges changes = watch->next(10000);
  ASSERT_EQ(changes.arrived.size(), 1u);
  EXPECT_EQ(changes.arrived[0].interface.identity.product, 2);
  EXPECT_TRUE(changes.left.empty());
  EXPECT_EQ(watch->tablets().size(), 2u);

  pull_out(0);
  changes = watch->next(10000);
  ASSERT_EQ(changes.left.size(), 1u);
  EXPECT_EQ(changes.left[0].interface.identity.product, 1);
  EXPECT_TRUE(changes.arrived.empty());
}

TEST_F(MockDevices, ATabletWhoseNodeIsLateArrivesOnce) {
  auto watch = TabletWatch::start();
  ASSERT_TRUE(watch);
  plug_in_ink();
  const std::string node = real("/dev/hidraw0");
  const std::string away = node + "-away";
  ASSERT_EQ(::rename(node.c_str(), away.c_str()), 0);
  tell_added(0);
  EXPECT_TRUE(watch->next(10000).empty());
  ASSERT_EQ(::rename(away.c_str(), node.c_str()), 0);
  tell_added(0);
  EXPECT_EQ(watch->next(10000).arrived.size(), 1u);
  EXPECT_TRUE(watch->next(0).empty());
}

TEST_F(MockDevices, ATabletThatNeverGetsANodeArrivesAfterAWhile) {
  auto watch = TabletWatch::start();
  ASSERT_TRUE(watch);
  plug_in_ink();
  ASSERT_EQ(::unlink(real("/dev/hidraw0").c_str()), 0);
  tell_added(0);
  EXPECT_TRUE(watch->next(10000).empty());
  // No event follows; the watch wakes by itself.
  const auto changes = watch->next(10000);
  ASSERT_EQ(changes.arrived.size(), 1u);
  EXPECT_EQ(changes.arrived[0].access, Access::absent);
  EXPECT_TRUE(watch->next(0).empty());
}

TEST_F(MockDevices, APenWithoutHidIsReadThroughItsEventDevice) {
  plug_in_i2c("/devices/i2c-1/1-0009");
  plug_in_event_pen("/devices/i2c-1/1-0009", 4, "Wacom I2C Digitizer");
  const auto list = tablets();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].path(), "/dev/input/event4");
  EXPECT_EQ(list[0].transport, Transport::event);
  EXPECT_EQ(list[0].carries, Carries::pen);
  EXPECT_EQ(list[0].interface.identity.name, "Wacom I2C Digitizer");
  EXPECT_EQ(list[0].interface.identity.bus, 0x18);
  EXPECT_NE(list[0].interface.parent.find("1-0009"), std::string::npos);
  EXPECT_EQ(list[0].access, Access::allowed);
  EXPECT_FALSE(list[0].interface.made_by_program);
  EXPECT_TRUE(list[0].wake_up().empty()) << "the kernel's driver has done that";
}

TEST_F(MockDevices, WhereHidrawMayBeOpenedItsEventDeviceIsNotListed) {
  plug_in_ink();
  plug_in_event_pen("/devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1B96:0001.0000", 4, "Ink pen");
  auto list = tablets();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].path(), "/dev/hidraw0");
  ASSERT_EQ(::chmod(real("/dev/input").c_str(), 0755), 0);
  protect("/dev/input/event4", 0644);
  protect("/dev/hidraw0", 0);
  const int status = as_nobody([] {
    const auto found = tablets();
    if (found.size() != 1 || found[0].path() != "/dev/input/event4") return 1;
    return found[0].access == Access::allowed && found[0].reason == "its HID interface cannot be opened" ? 0 : 2;
  });
  EXPECT_EQ(status, 0);
}

TEST_F(MockDevices, AnEventDeviceThatWasThereFirstIsReplacedByItsHidrawNode) {
  plug_in_ink();
  plug_in_event_pen("/devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1B96:0001.0000", 4, "Ink pen");
  const std::string node = real("/dev/hidraw0");
  const std::string away = node + "-away";
  ASSERT_EQ(::rename(node.c_str(), away.c_str()), 0);
  auto watch = TabletWatch::start();
  ASSERT_TRUE(watch);
  ASSERT_EQ(watch->tablets().size(), 1u);
  EXPECT_EQ(watch->tablets()[0].path(), "/dev/input/event4");
  ASSERT_EQ(::rename(away.c_str(), node.c_str()), 0);
  tell_added(0);
  const TabletChanges changes = watch->next(10000);
  ASSERT_EQ(changes.arrived.size(), 1u);
  EXPECT_EQ(changes.arrived[0].path(), "/dev/hidraw0");
  ASSERT_EQ(changes.left.size(), 1u);
  EXPECT_TRUE(changes.replaced(changes.left[0]));
}

TEST_F(MockDevices, WithoutPermissionForAnEventDeviceTheGroupIsNamed) {
  plug_in_i2c("/devices/i2c-1/1-0009");
  plug_in_event_pen("/devices/i2c-1/1-0009", 4, "Wacom I2C Digitizer");
  protect("/dev/input/event4", 0);
  const int status = as_nobody([] {
    const auto list = tablets();
    if (list.size() != 1 || list[0].access != Access::denied) return 1;
    const std::string said = missing(list[0], "/opt/penpose");
    if (said.find("run: sudo /opt/penpose devices --install-udev-rule") == std::string::npos) return 2;
    return said.find("sudo usermod -aG input $USER") != std::string::npos ? 0 : 3;
  });
  EXPECT_EQ(status, 0);
}

TEST_F(MockDevices, DamagedFactsAreSurvived) {
  plug_in("1-1", 0, std::vector<std::uint8_t>(300, 0xff), "Nonsense", "hid-generic", "ZZZZ", "0");
  plug_in("1-2", 0, {}, "", "hid-generic", "1B96", "0001");
  EXPECT_TRUE(tablets().empty());
  const auto interfaces = list_interfaces();
  EXPECT_EQ(interfaces.size(), 2u);
}

}  // namespace
}  // namespace penpose::device
