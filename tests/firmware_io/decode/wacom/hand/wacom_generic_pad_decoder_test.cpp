#include "firmware_io/decode/wacom/hand/wacom_generic_pad_decoder.h"

#include <gtest/gtest.h>

#include "tests/support/hands/hand_descriptors.h"

namespace penpose::decode {
namespace {

using tests::Report;

constexpr std::uint16_t k_intuos_pro_2017 = 0x0357;
constexpr std::uint16_t k_mobile_studio = 0x034d;
constexpr std::uint16_t k_other = 0x0ff0;

std::unique_ptr<WacomGenericPadDecoder> pad_of(const Report& descriptor, std::uint16_t product,
                                               std::shared_ptr<TouchSwitch> touch = nullptr) {
  const auto parsed = hid::parse_report_descriptor(descriptor);
  EXPECT_TRUE(parsed.ok());
  auto layout = find_wacom_pad(*parsed, product);
  EXPECT_TRUE(layout.has_value());
  return std::make_unique<WacomGenericPadDecoder>(std::move(*layout), std::move(touch));
}
/// What the ring says while nothing touches it: a place that is none.
constexpr int k_no_place = 127;

/// Keys, more keys, the ring with its status in bit 0, the battery with charging in bit 7.
Report report_of(std::uint8_t keys, std::uint8_t more, bool touched, int ring, std::uint8_t battery = 0) {
  return {0x11, keys, more, static_cast<std::uint8_t>(ring << 1 | (touched ? 1 : 0)), battery};
}

TEST(WacomGenericPadDecoder, KeysAreNumberedAsTheyAreDescribed) {
  const auto pad = pad_of(tests::wacom_pad_descriptor(), k_other);
  EXPECT_EQ(pad->features().keys, numbered_keys(0x1ff, 9));
  ASSERT_TRUE(pad->decode(report_of(0x81, 0x01, false, k_no_place)));
  EXPECT_EQ(key_names(pad->sample().keys), "BTN_0+BTN_7+BTN_8");
  EXPECT_EQ(pad->sample().mode[0], 1);
  ASSERT_TRUE(pad->decode(report_of(0, 0, false, k_no_place)));
  EXPECT_TRUE(pad->sample().keys.empty());
  EXPECT_FALSE(pad->decode(report_of(0, 0, false, k_no_place)));
}

TEST(WacomGenericPadDecoder, RingsBeginAtTheLeftWhateverTheModelCounts) {
  // Of 72 places: a quarter turn on; against the clock and 3 of 16 parts on; against the clock and half a turn on.
  for (const auto& [product, told, meant] : {std::tuple{k_other, 0, 18},
                                             {k_other, 60, 6},
                                             {k_intuos_pro_2017, 71, 13},
                                             {k_intuos_pro_2017, 0, 12},
                                             {k_mobile_studio, 71, 36},
                                             {k_mobile_studio, 0, 35}}) {
    const auto pad = pad_of(tests::wacom_pad_descriptor(), product);
    ASSERT_TRUE(pad->decode(report_of(0, 0, true, told)));
    EXPECT_EQ(pad->sample().ring[0], meant) << std::hex << product << ' ' << told;
    EXPECT_TRUE(pad->sample().ring_touched[0]);
  }
}

TEST(WacomGenericPadDecoder, AValueBeyondItsRangeIsNone) {
  const auto pad = pad_of(tests::wacom_pad_descriptor(), k_other);
  pad->decode(report_of(1, 0, true, 10));
  const auto before = pad->sample().ring[0];
  pad->decode(report_of(1, 0, true, 100));
  EXPECT_EQ(pad->sample().ring[0], before);
}

TEST(WacomGenericPadDecoder, TellsOfTheBatteryAndTheTouchSwitch) {
  const auto touch = std::make_shared<TouchSwitch>();
  touch->has_touch = true;
  const auto pad = pad_of(tests::wacom_pad_descriptor(), k_other, touch);
  EXPECT_TRUE(touch->mutes());
  pad->decode(report_of(0, 0x02, false, k_no_place, 0x80 | 40));
  EXPECT_FALSE(touch->mutes());
  EXPECT_EQ(pad->battery(), (Battery{40, true}));
  pad->decode(report_of(0, 0, false, k_no_place, 39));
  EXPECT_TRUE(touch->mutes());
  EXPECT_EQ(pad->battery(), (Battery{39, false}));
}

TEST(WacomGenericPadDecoder, ARingMayTurnInsteadOfBeingTouched) {
  Report items{0x06, 0x0d, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x85, 0x11, 0x06, 0x0d, 0xff, 0x09, 0x39, 0xa1, 0x00};
  Report turn = tests::input({0xff0d0138}, 8, 1, 127, 0x06);
  const Report from_below{0x15, 0x81};
  turn.erase(turn.begin() + 5, turn.begin() + 7);
  turn.insert(turn.begin() + 5, from_below.begin(), from_below.end());
  tests::append(items, turn);
  tests::append(items, {0xc0, 0xc0});
  const auto pad = pad_of(items, k_other);
  EXPECT_EQ(pad->features().wheels, 1u);
  EXPECT_EQ(pad->features().rings, 0u);
  ASSERT_TRUE(pad->decode(Report{0x11, 0xfe}));
  EXPECT_EQ(pad->sample().wheel[0], 2);
  EXPECT_EQ(pad->sample().fine_wheel[0], 240);
}

TEST(WacomGenericPadDecoder, ShortAndForeignReportsSayNothing) {
  const auto pad = pad_of(tests::wacom_pad_descriptor(), k_other);
  EXPECT_FALSE(pad->decode({}));
  EXPECT_FALSE(pad->decode(Report{0x11, 0xff, 0, 0}));
  EXPECT_FALSE(pad->decode(Report{0x12, 0xff, 0, 0, 0}));
  pad->decode(report_of(1, 0, false, k_no_place));
  pad->reset();
  EXPECT_EQ(pad->sample(), PadSample{});
}

TEST(WacomGenericPadDecoder, AMouseHasNoPad) {
  const auto parsed = hid::parse_report_descriptor(tests::touch_descriptor(1));
  EXPECT_FALSE(find_wacom_pad(*parsed, k_other).has_value());
}

}  // namespace
}  // namespace penpose::decode
