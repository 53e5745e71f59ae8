#include "firmware_io/decode/layout/vendor_pad_decoder.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/layout/layout_decoder.h"
#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/table/tablet_reader.h"
#include "tests/support/hands/pen_reports.h"

namespace penpose::decode {
namespace {

using tests::Report;

std::unique_ptr<VendorPadDecoder> pad_of(const std::string& name, const Tablet* tablet = nullptr) {
  const auto protocol = known_protocols().at(name);
  return std::make_unique<VendorPadDecoder>(std::make_unique<LayoutDecoder>(protocol), *protocol, tablet);
}

TEST(VendorPadDecoder, KeysAndRingOfAHuion) {
  Tablet tablet;
  tablet.pad_keys = 6;
  tablet.wheels.push_back({true, 12, 0, 1});
  const auto pad = pad_of("huion_ring", &tablet);
  EXPECT_EQ(pad->features().keys, numbered_keys(0x7f, 7));
  EXPECT_EQ(pad->features().rings, 1u);
  EXPECT_EQ(pad->features().ring_maximum, 11);
  ASSERT_TRUE(pad->decode(Report{8, 0xe0, 1, 1, 0x21, 0x10, 0}));
  EXPECT_EQ(key_names(pad->sample().keys), "BTN_0+BTN_5+BTN_6");
  ASSERT_TRUE(pad->decode(Report{8, 0xf0, 1, 1, 0, 12}));
  EXPECT_TRUE(pad->sample().ring_touched[0]);
  EXPECT_EQ(pad->sample().ring[0], 11);
  ASSERT_TRUE(pad->decode(Report{8, 0xf0, 1, 1, 0, 0}));
  EXPECT_FALSE(pad->sample().ring_touched[0]);
  EXPECT_EQ(pad->sample().ring[0], 0);
}

TEST(VendorPadDecoder, RingsAndStripsOfATabletFile) {
  const auto table = read_tablet_file(R"({"penpose_tablets": 1, "protocols": {"mine": {"rules": [
    {"when": "0=06", "gives": "pad", "ring": "1", "second_ring": "2 if 2!=00", "strip": "3", "second_strip": "4"}]}},
    "tablets": [{"vendor": "Me", "name": "Mine", "size_mm": [1, 1], "max": [1, 1], "max_pressure": 1,
    "wheels": [{"kind": "ring", "steps": 36}, {"kind": "ring", "steps": 36}], "strips": 2,
    "identifiers": [{"id": "1234:0001", "protocol": "mine"}]}]})");
  ASSERT_TRUE(table.ok()) << table.error().line();
  const Tablet& tablet = table->tablets()[0];
  const auto& protocol = tablet.identifiers[0].protocol;
  VendorPadDecoder pad(std::make_unique<LayoutDecoder>(protocol), *protocol, &tablet);
  EXPECT_EQ(pad.features().rings, 2u);
  EXPECT_EQ(pad.features().strips, 2u);
  EXPECT_TRUE(pad.features().keys.empty());
  ASSERT_TRUE(pad.decode(Report{6, 10, 20, 30, 40}));
  EXPECT_EQ(pad.sample().ring, (std::array<std::int32_t, 2>{10, 20}));
  EXPECT_EQ(pad.sample().strip, (std::array<std::int32_t, 2>{30, 40}));
  ASSERT_TRUE(pad.decode(Report{6, 10, 0, 0, 0}));
  EXPECT_EQ(pad.sample().ring_touched, (std::array<bool, 2>{true, false}));
  EXPECT_EQ(pad.sample().ring[1], 0);
}

TEST(VendorPadDecoder, WheelsOfAnXpPen) {
  using Wheels = std::array<std::int32_t, 2>;
  const auto pad = pad_of("xp_pen");
  ASSERT_TRUE(pad->decode(Report{2, 0xf0, 0x20, 0, 0, 0, 0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(key_names(pad->sample().keys), "BTN_5");
  EXPECT_EQ(pad->sample().wheel, (Wheels{1, 0}));
  ASSERT_TRUE(pad->decode(Report{2, 0xf0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_TRUE(pad->sample().keys.empty());
  EXPECT_EQ(pad->sample().wheel, (Wheels{0, 0}));
  ASSERT_TRUE(pad->decode(Report{2, 0xf0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0}));
  EXPECT_EQ(pad->sample().wheel, (Wheels{-1, 0}));
  ASSERT_TRUE(pad->decode(Report{2, 0xf0, 0, 0, 0, 0, 0, 0x10, 0, 0, 0, 0}));
  EXPECT_EQ(pad->sample().wheel, (Wheels{0, 1}));
  ASSERT_TRUE(pad->decode(Report{2, 0xf0, 0, 0, 0, 0, 0, 0x20, 0, 0, 0, 0}));
  EXPECT_EQ(pad->sample().wheel, (Wheels{0, -1}));
  // A report that ends before the wheels still has keys.
  ASSERT_TRUE(pad->decode(Report{2, 0xf0, 1, 0, 0}));
  EXPECT_EQ(key_names(pad->sample().keys), "BTN_0");
}

TEST(VendorPadDecoder, PenReportsSayNothing) {
  const auto pad = pad_of("huion_ring");
  EXPECT_FALSE(pad->decode(Report{8, 0x81, 1, 0, 2, 0, 3, 0, 0, 0, 0, 0}));
}

TEST(VendorPadDecoder, ProtocolsWithoutKeysHaveNoPad) {
  EXPECT_FALSE(has_pad(*known_protocols().at("wacom_pl")));
  EXPECT_FALSE(has_pad(*known_protocols().at("lifetec")));
  EXPECT_TRUE(has_pad(*known_protocols().at("xp_pen")));
  EXPECT_TRUE(has_pad(*known_protocols().at("generic_keypad")));
}

}  // namespace
}  // namespace penpose::decode
