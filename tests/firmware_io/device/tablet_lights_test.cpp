#include "firmware_io/device/tablet_lights.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace penpose::device {
namespace {

/// The kernel's lights as files, in a folder that goes with the test.
class TabletLights : public testing::Test {
 protected:
  TabletLights() : folder_(std::filesystem::temp_directory_path() / ("penpose-lights-" + std::to_string(::getpid()))) {
    interface_.hid_name = "0003:056A:0314.0001";
    interface_.identity.vendor = 0x056a;
    interface_.identity.product = 0x0314;
  }
  ~TabletLights() override { std::filesystem::remove_all(folder_); }

  void light(int group, int number, int brightness) const {
    const auto path = folder_ / interface_.hid_name / "input/input7" /
                      ("input7::wacom-" + std::to_string(group) + "." + std::to_string(number));
    std::filesystem::create_directories(path);
    std::ofstream(path / "brightness") << brightness << '\n';
  }
  [[nodiscard]] std::optional<decode::Lights> seen() const { return seen_lights(interface_, folder_.string()); }

  std::filesystem::path folder_;
  HidInterface interface_;
};

TEST_F(TabletLights, TheOneThatIsOnIsSeen) {
  EXPECT_EQ(seen(), std::nullopt);
  for (int i = 0; i < 4; ++i) light(0, i, i == 2 ? 85 : 0);
  EXPECT_EQ(seen(), (decode::Lights{2, 0}));
}

TEST_F(TabletLights, OfTwoGroupsTheFirstIsAtTheRight) {
  interface_.identity.product = 0x00cc;
  for (int i = 0; i < 4; ++i) {
    light(0, i, i == 3 ? 255 : 0);
    light(1, i, i == 1 ? 255 : 0);
  }
  EXPECT_EQ(seen(), (decode::Lights{1, 3}));
}

TEST_F(TabletLights, OtherThingsOfAnInputDeviceAreNoLights) {
  light(0, 0, 0);
  for (const char* name :
       {"input7::capslock", "input7::wacom-0.9", "input7::wacom-7.0", "input7::wacom-0.10", "event3"}) {
    const auto path = folder_ / interface_.hid_name / "input/input7" / name;
    std::filesystem::create_directories(path);
    std::ofstream(path / "brightness") << "1\n";
  }
  EXPECT_EQ(seen(), (decode::Lights{0, 0}));
}

TEST_F(TabletLights, TheKernelsDriverSwitchesThemWhereItHasTheTablet) {
  LiveTablet tablet;
  tablet.interface = interface_;
  tablet.interface.driver = "wacom";
  EXPECT_TRUE(kernel_switches_lights(tablet));
  tablet.transport = Transport::libusb;
  EXPECT_FALSE(kernel_switches_lights(tablet));
  tablet.transport = Transport::hidraw;
  tablet.interface.driver = "hid-generic";
  EXPECT_FALSE(kernel_switches_lights(tablet));
}

}  // namespace
}  // namespace penpose::device
