#include "firmware_io/device/live_tablet.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/device/list/permission.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/wacom_receiver.h"

namespace penpose::device {
namespace {

/// A vendor interface whose reports have 12 bytes, the id among them, and which describes no pen.
std::vector<std::uint8_t> huion_descriptor() {
  return {0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x85, 0x08, 0x75, 0x08, 0x95,
          0x0b, 0x15, 0x00, 0x26, 0xff, 0x00, 0x09, 0x01, 0x81, 0x02, 0xc0};
}

HidInterface huion() {
  HidInterface interface;
  interface.identity.vendor = 0x256c;
  interface.identity.product = 0x006d;
  interface.identity.name = "Tablet";
  interface.identity.report_descriptor = huion_descriptor();
  decode::complete_identity(interface.identity);
  interface.hidraw_node = "/nowhere/hidraw0";
  interface.usb_node = "/nowhere/usb";
  interface.usb_name = "1-1:1.0";
  interface.driver = "hid-generic";
  return interface;
}

class Strings {
 public:
  [[nodiscard]] ReadString reader(std::string firmware, std::uint8_t at = 201) {
    return [this, firmware = std::move(firmware), at](const std::string& node, std::uint8_t index) {
      EXPECT_EQ(node, "/nowhere/usb");
      asked_.push_back(index);
      return index == at ? base::Result<std::string>(firmware) : base::Result<std::string>(base::Error{"none", "", ""});
    };
  }
  std::vector<int> asked_;
};

TEST(Recognise, TheFirmwareStringTellsTheTabletAndHowToWakeIt) {
  Strings strings;
  const LiveTablet tablet = recognise(huion(), nullptr, strings.reader("HUION_T173_200101"));
  ASSERT_TRUE(tablet.match);
  EXPECT_TRUE(tablet.match->certain);
  EXPECT_EQ(tablet.guess, "");
  EXPECT_EQ(tablet.match->tablet->name, "H640P");
  EXPECT_EQ(tablet.carries, Carries::pen);
  EXPECT_EQ(wake_up_of(tablet.match).read_strings, std::vector<std::uint8_t>{200});
  EXPECT_EQ(tablet.transport, Transport::libusb) << "its wake-up needs USB";
  EXPECT_EQ(tablet.path(), "usb:1-1:1.0");
  EXPECT_EQ(std::count(strings.asked_.begin(), strings.asked_.end(), 200), 0) << "that one would wake it up already";
}

TEST(Recognise, ATabletThatNoTableHasIsAskedForItsRanges) {
  Strings strings;
  HidInterface interface = huion();
  interface.identity.product = 0x2fff;
  const LiveTablet tablet = recognise(interface, nullptr, strings.reader("70c600067c00ff1fd813", 200));
  EXPECT_EQ(tablet.carries, Carries::pen);
  EXPECT_EQ(tablet.method, "protocol huion_giano");
  EXPECT_EQ(tablet.transport, Transport::hidraw) << "it is awake now";
  EXPECT_EQ(tablet.interface.identity.strings.at(200), "70c600067c00ff1fd813") << "for recordings and replays";
  EXPECT_EQ(recognise(interface, nullptr, strings.reader("")).carries, Carries::other);
  interface.identity.vendor = 0x1234;
  strings.asked_.clear();
  EXPECT_EQ(recognise(interface, nullptr, strings.reader("")).carries, Carries::other);
  EXPECT_TRUE(strings.asked_.empty()) << "others are left alone";
}

TEST(Recognise, AStringThatIsKnownIsNotAskedForAgain) {
  HidInterface interface = huion();
  interface.identity.strings = {{201, "HUION_T173_200101"}};
  Strings strings;
  const LiveTablet tablet = recognise(std::move(interface), nullptr, strings.reader("another one"));
  EXPECT_EQ(std::count(strings.asked_.begin(), strings.asked_.end(), 201), 0);
  ASSERT_TRUE(tablet.match);
  EXPECT_EQ(tablet.match->tablet->name, "H640P");
}

TEST(Recognise, ATabletThatMayBeAnotherIsSentNothing) {
  HidInterface interface = huion();
  interface.usb_node.clear();
  const LiveTablet tablet = recognise(std::move(interface));
  ASSERT_TRUE(tablet.match);
  EXPECT_FALSE(tablet.match->certain);
  EXPECT_NE(tablet.guess.find(", read as " + tablet.match->tablet->vendor + ' ' + tablet.match->tablet->name),
            std::string::npos)
      << tablet.guess;
  EXPECT_TRUE(wake_up_of(tablet.match).empty());
  EXPECT_EQ(tablet.transport, Transport::hidraw);
}

TEST(Recognise, NoStringIsReadWhereTheTableAsksForNone) {
  HidInterface interface = huion();
  interface.identity.vendor = 0x1b96;
  interface.identity.report_descriptor = tests::ink_descriptor();
  interface.identity.input_report_length.reset();
  Strings strings;
  const LiveTablet tablet = recognise(std::move(interface), nullptr, strings.reader(""));
  EXPECT_TRUE(strings.asked_.empty());
  EXPECT_EQ(tablet.method, "descriptor");
  EXPECT_EQ(tablet.transport, Transport::hidraw);
}

TEST(Recognise, ATabletThatTheKernelHasWokenIsReadBesideItsDriver) {
  HidInterface interface = huion();
  interface.identity.report_descriptor = tests::ink_descriptor();  // as the driver describes it
  interface.driver = "uclogic";
  Strings strings;
  const LiveTablet tablet = recognise(std::move(interface), nullptr, strings.reader("HUION_T173_200101"));
  EXPECT_EQ(tablet.carries, Carries::pen);
  EXPECT_EQ(tablet.transport, Transport::hidraw);
  EXPECT_TRUE(tablet.wake_up().empty());
}

TEST(Recognise, AnOldWacomIsMadeAPenUnlessTheKernelDoesIt) {
  HidInterface interface = huion();
  interface.identity.bus = decode::k_bus_usb;
  interface.identity.vendor = 0x056a;
  interface.identity.product = 0x0000;
  interface.identity.report_descriptor.clear();
  interface.driver = "wacom";
  LiveTablet penpartner = recognise(interface);
  EXPECT_EQ(penpartner.method, "wacom PenPartner");
  EXPECT_EQ(penpartner.transport, Transport::libusb);
  EXPECT_EQ(penpartner.wake_up().send_features, (std::vector<std::vector<std::uint8_t>>{{2, 2}}));
  EXPECT_TRUE(penpartner.wake_up().ask_first);

  interface.identity.product = 0x0013;  // Graphire3
  EXPECT_EQ(recognise(interface).transport, Transport::hidraw);
  EXPECT_TRUE(recognise(interface).wake_up().empty()) << "its driver does it";
  interface.driver = "hid-generic";
  EXPECT_EQ(recognise(interface).wake_up().send_features, penpartner.wake_up().send_features);
  interface.identity.bus = 0x18;
  EXPECT_TRUE(recognise(interface).wake_up().empty()) << "I2C has other ids";
}

TEST(Recognise, WithoutANodeOfItsOwnAnInterfaceIsReadThroughUsb) {
  HidInterface interface = huion();
  interface.identity.report_descriptor = tests::ink_descriptor();
  interface.hidraw_node.clear();
  const LiveTablet tablet = recognise(std::move(interface));
  EXPECT_EQ(tablet.transport, Transport::libusb);
  EXPECT_EQ(tablet.access, Access::absent);
}

TEST(Recognise, AllInterfacesOfAWirelessReceiverAreRead) {
  const auto of = [](int number) {
    HidInterface interface;
    interface.identity = tests::receiver(number);
    interface.hidraw_node = "/nowhere/hidraw" + std::to_string(number);
    return recognise(std::move(interface));
  };
  EXPECT_EQ(of(0).carries, Carries::receiver);
  EXPECT_EQ(of(1).carries, Carries::pen);
  EXPECT_EQ(of(2).carries, Carries::touch);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(of(i).method.empty());
    EXPECT_TRUE(of(i).wake_up().empty());
  }
}

TEST(Recognise, AMouseCarriesNoPen) {
  HidInterface interface = huion();
  interface.identity.vendor = 0x046d;
  EXPECT_EQ(recognise(std::move(interface)).carries, Carries::other);
}

TEST(UdevRule, TheOneInTheRepositoryIsTheOneThatIsPrinted) {
  std::ifstream file(PENPOSE_UDEV_RULE);
  const std::string kept{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(kept, udev_rule(decode::known_tablets())) << "renew it with: penpose devices --udev-rule";
}

TEST(UdevRule, GivesAccessToWhoeverSitsThereAndToNobodyElse) {
  const std::string rule = udev_rule(decode::known_tablets());
  // But where no logind knows who that is: there a group, and no more than that.
  const auto group = rule.find("GROUP");
  EXPECT_EQ(rule.find("GROUP", group + 1), std::string::npos);
  const std::string last = rule.substr(rule.rfind('\n', group) + 1);
  EXPECT_EQ(last.substr(0, last.find('\n')),
            "ENV{PENPOSE_TABLET}==\"1\", TEST!=\"/run/systemd/seats\", GROUP=\"input\", MODE=\"0660\"");
  EXPECT_NE(rule.find("TAG+=\"uaccess\""), std::string::npos);
  EXPECT_NE(rule.find("*:256C:006D.*"), std::string::npos);
  EXPECT_NE(rule.find("*:2D1F:*"), std::string::npos) << "Wacom's digitizers in notebooks";
  EXPECT_NE(rule.find("*:27C6:0113.*"), std::string::npos) << "of other makers by number";
  EXPECT_EQ(rule.find("*:04F3:*"), std::string::npos) << "who build keyboards as well";
  std::istringstream lines(rule);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 8000u) << "udev reads lines of 16 KiB";
  // Each line that gives something names a maker.
  EXPECT_LT(std::string(k_rule_file), "73");
}

TEST(UdevRule, TakesInWhatIsPluggedIn) {
  LiveTablet tablet;
  tablet.interface.identity.vendor = 0x1b96;
  tablet.interface.identity.product = 0x0abc;
  EXPECT_NE(udev_rule(decode::known_tablets(), {tablet}).find("*:1B96:0ABC.*"), std::string::npos);
}

}  // namespace
}  // namespace penpose::device
