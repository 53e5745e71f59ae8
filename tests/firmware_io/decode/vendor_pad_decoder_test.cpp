#include "firmware_io/decode/vendor_pad_decoder.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/layout_decoder.h"
#include "firmware_io/decode/protocol.h"
#include "tests/support/pen_reports.h"

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
