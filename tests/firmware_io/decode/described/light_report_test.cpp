#include "firmware_io/decode/described/light_report.h"

#include <gtest/gtest.h>

#include "tests/support/hands/hand_descriptors.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/wacom_receiver.h"

namespace penpose::decode {
namespace {

/// A vendor's feature report of `size` bytes, its id among them.
tests::Report feature_descriptor(std::uint8_t id, std::uint8_t size, std::uint16_t usage = 0x0001,
                                 std::uint16_t page = 0xff00) {
  return {0x06,
          tests::low(page),
          tests::high(page),
          0x09,
          0x01,
          0xa1,
          0x01,
          0x85,
          id,
          0x0a,
          tests::low(usage),
          tests::high(usage),
          0x15,
          0x00,
          0x26,
          0xff,
          0x00,
          0x75,
          0x08,
          0x95,
          static_cast<std::uint8_t>(size - 1),
          0xb1,
          0x02,
          0xc0};
}

DeviceIdentity tablet(std::uint16_t product, tests::Report descriptor, std::uint16_t bus = k_bus_usb) {
  DeviceIdentity identity;
  identity.bus = bus;
  identity.vendor = 0x056a;
  identity.product = product;
  identity.report_descriptor = std::move(descriptor);
  return identity;
}

using Bytes = std::vector<std::uint8_t>;

// The bytes are those that Linux's driver sends for the same lights (wacom_sys.c, wacom_led_control).

TEST(LightReport, OfIntuos4HasTheBrightnessOfItsKeysToo) {
  EXPECT_EQ(light_report(tablet(0x00b9, feature_descriptor(0x20, 9)), {2, 0}),
            (Bytes{0x20, 0x06, 10, 20, 10, 0, 0, 0, 0}));
}

TEST(LightReport, OfIntuos5AndIntuosPro) {
  EXPECT_EQ(light_report(tablet(0x0026, feature_descriptor(0x20, 9)), {3, 0}),
            (Bytes{0x20, 0x03, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(light_report(tablet(0x0314, feature_descriptor(0x20, 9)), {1, 0}),
            (Bytes{0x20, 0x01, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(LightReport, OfTwoSidesTheRightOneIsTheFirstGroup) {
  EXPECT_EQ(light_report(tablet(0x00cc, feature_descriptor(0x20, 9)), {3, 1}),
            (Bytes{0x20, 0x75, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(light_report(tablet(0x00f4, feature_descriptor(0x20, 9)), {0, 2}),
            (Bytes{0x20, 0x46, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(side_of_light_group(tablet(0x00f4, {}), 0), 1U);
  EXPECT_EQ(side_of_light_group(tablet(0x00cc, {}), 1), 0U);
  EXPECT_EQ(side_of_light_group(tablet(0x0314, {}), 0), 0U);
}

TEST(LightReport, OverBluetooth) {
  const auto report = light_report(tablet(0x0360, feature_descriptor(0x82, 51), k_bus_bluetooth), {2, 0});
  ASSERT_TRUE(report);
  ASSERT_EQ(report->size(), 51U);
  EXPECT_EQ(Bytes(report->begin(), report->begin() + 12), (Bytes{0x82, 0, 0, 0, 100, 100, 100, 100, 100, 50, 2, 0}));
}

TEST(LightReport, OfTabletsThatDescribeTheSettingOfTheirRing) {
  EXPECT_EQ(light_report(tablet(0x0357, feature_descriptor(0x32, 3, 0x1032, 0xff0d)), {3, 0}), (Bytes{0x32, 100, 3}));
  EXPECT_EQ(light_report(tablet(0x0357, feature_descriptor(0x32, 3)), {3, 0}), std::nullopt) << "another setting";
  EXPECT_EQ(light_report(tablet(0x0357, feature_descriptor(0x33, 3, 0x1032, 0xff0d)), {3, 0}), std::nullopt)
      << "by another report";
}

TEST(LightReport, NothingIsSentThatATabletDoesNotDeclare) {
  EXPECT_EQ(light_report(tablet(0x0314, feature_descriptor(0x20, 6)), {1, 0}), std::nullopt) << "of another length";
  EXPECT_EQ(light_report(tablet(0x0314, feature_descriptor(0x21, 9)), {1, 0}), std::nullopt) << "of another id";
  EXPECT_EQ(light_report(tablet(0x0314, {}), {1, 0}), std::nullopt) << "nothing is known";
  EXPECT_EQ(light_report(tablet(0x00fa, feature_descriptor(0x20, 9)), {1, 0}), std::nullopt) << "it has no lights";
  EXPECT_EQ(light_report(tablet(0x0331, feature_descriptor(0x20, 9)), {1, 0}), std::nullopt)
      << "the remote switches its own";
  DeviceIdentity other = tablet(0x0314, feature_descriptor(0x20, 9));
  other.vendor = 0x256c;
  EXPECT_EQ(light_report(other, {1, 0}), std::nullopt);
}

TEST(LightReport, BehindAReceiverItIsOneByteOfTheReceiversOwn) {
  const DeviceIdentity keys = tests::receiver(1);
  EXPECT_EQ(light_report(keys, {2, 0}), (Bytes{0x03, 0, 0, 0, 0x02, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(only_light_byte(keys), 4U);
  for (const int other : {0, 2}) {
    EXPECT_EQ(light_report(tests::receiver(other), {2, 0}), std::nullopt) << "interface " << other;
    EXPECT_EQ(only_light_byte(tests::receiver(other)), std::nullopt);
  }
  EXPECT_EQ(only_light_byte(tablet(0x0314, feature_descriptor(0x20, 9))), std::nullopt)
      << "by cable all bytes are ours";
}

}  // namespace
}  // namespace penpose::decode
