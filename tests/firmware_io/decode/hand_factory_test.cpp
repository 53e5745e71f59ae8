#include "firmware_io/decode/hand_factory.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/table/tablet_reader.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "tests/support/hands/hand_descriptors.h"

namespace penpose::decode {
namespace {

using tests::device;

TEST(HandFactory, AWacomFormatGoesByProductAndInterface) {
  const auto pen_side = make_hand_decoders(device(k_vendor_wacom, 0x0314, tests::ink_descriptor()));
  ASSERT_TRUE(pen_side.pad);
  EXPECT_FALSE(pen_side.touch);
  tests::Report opaque{0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x85, 0x02, 0x09, 0x01, 0x15,
                       0x00, 0x26, 0xff, 0x00, 0x75, 0x08, 0x95, 0x3f, 0x81, 0x02, 0xc0};
  const auto touch_side = make_hand_decoders(device(k_vendor_wacom, 0x0314, opaque));
  EXPECT_FALSE(touch_side.pad);
  ASSERT_TRUE(touch_side.touch);
  EXPECT_EQ(touch_side.touch->axes().contacts, 16u);
  EXPECT_EQ(touch_side.touch->axes().x.maximum, 4096);
  // Where the keys come with the fingers, that is where they are looked for.
  EXPECT_TRUE(make_hand_decoders(device(k_vendor_wacom, 0x0302, opaque)).pad);
  EXPECT_FALSE(make_hand_decoders(device(k_vendor_wacom, 0x0302, tests::ink_descriptor())).pad);
}

TEST(HandFactory, ATabletWithoutKeysHasNone) {
  const auto made = make_hand_decoders(device(k_vendor_wacom, 0x0041, tests::ink_descriptor()));
  EXPECT_FALSE(made.pad);
  EXPECT_FALSE(made.touch);
}

TEST(HandFactory, DescribedKeysAndFingersOfWacom) {
  const auto shared = std::make_shared<TouchSwitch>();
  auto fingers = make_hand_decoders(device(k_vendor_wacom, 0xfff0, tests::touch_descriptor(2)), nullptr, shared);
  auto keys = make_hand_decoders(device(k_vendor_wacom, 0xfff0, tests::wacom_pad_descriptor()), nullptr, shared);
  ASSERT_TRUE(fingers.touch);
  ASSERT_TRUE(keys.pad);
  const auto down = tests::touch_report({{5, 1, 10, 20}, {0, 0, 0, 0}}, 1);
  // The slide that turns touch on is on the other interface.
  fingers.touch->decode(down);
  EXPECT_TRUE(fingers.touch->contacts().empty());
  keys.pad->decode(tests::Report{0x11, 0, 0x02, 0, 0});
  fingers.touch->decode(down);
  EXPECT_EQ(fingers.touch->contacts().size(), 1u);
}

TEST(HandFactory, DescribedFingersOfAnyone) {
  const auto made = make_hand_decoders(device(0x1b96, 0x1000, tests::touch_descriptor(2)));
  EXPECT_TRUE(made.touch);
  EXPECT_FALSE(made.pad);
}

TEST(HandFactory, TheTablesTabletsHaveTheirProtocolsKeys) {
  unsigned with_keys = 0;
  for (const Tablet& tablet : known_tablets().tablets()) {
    const auto& identifier = tablet.identifiers.front();
    if (tablet.pad_keys == 0 || identifier.vendor == k_vendor_wacom) continue;
    DeviceIdentity known = device(identifier.vendor, identifier.product);
    known.input_report_length = identifier.input_report_length;
    const auto made = make_hand_decoders(known);
    if (made.pad && !made.pad->features().keys.empty()) ++with_keys;
  }
  EXPECT_GE(with_keys, 100u);
}

TEST(HandFactory, AUsersTabletGoesFirst) {
  const auto own = read_tablet_file(R"({"penpose_tablets": 1, "protocols": {"mine": {"rules": [
    {"when": "0=07", "gives": "pad", "keys": "1"}]}}, "tablets": [{"vendor": "Me", "name": "Mine",
    "size_mm": [100, 100], "max": [1, 1], "max_pressure": 1, "pad_keys": 2,
    "identifiers": [{"id": "056a:0314", "protocol": "mine"}]}]})");
  ASSERT_TRUE(own.ok()) << own.error().line();
  const auto made = make_hand_decoders(device(k_vendor_wacom, 0x0314), &*own);
  ASSERT_TRUE(made.pad);
  ASSERT_TRUE(made.pad->decode(tests::Report{7, 2}));
  EXPECT_EQ(key_names(made.pad->sample().keys), "BTN_1");
}

TEST(HandFactory, ProtocolsByName) {
  EXPECT_TRUE(make_protocol_hand_decoders("huion_ring").pad);
  EXPECT_FALSE(make_protocol_hand_decoders("wacom_pl").pad);
  EXPECT_FALSE(make_protocol_hand_decoders("nothing").pad);
  auto touch = make_protocol_hand_decoders("wacom_touch64").touch;
  ASSERT_TRUE(touch);
  touch->decode(tests::wacom_touch64({{3, true, 16, 0}}));
  ASSERT_EQ(touch->contacts().size(), 1u);
  EXPECT_EQ(touch->contacts()[0].x, 16);
}

}  // namespace
}  // namespace penpose::decode
