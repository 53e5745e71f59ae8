#include "firmware_io/decode/wacom/wacom_receiver.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/hand_factory.h"
#include "tests/support/hands/hand_descriptors.h"
#include "tests/support/hands/wacom_hand.h"
#include "tests/support/hands/wacom_receiver.h"

namespace penpose::decode {
namespace {

constexpr std::uint16_t k_intuos5_s = 0x0026;
constexpr std::uint16_t k_bamboo = 0x00de;

class WacomReceiverTest : public testing::Test {
 protected:
  WacomReceiverTest() {
    for (int i = 0; i < 3; ++i) first_[static_cast<std::size_t>(i)] = receivers_.connect(i, tests::receiver(i));
  }
  std::vector<WacomReceivers::Change> hear(unsigned product, int device = 0) {
    const auto changes = receivers_.report(device, tests::receiver_status(product));
    return {changes.begin(), changes.end()};
  }

  WacomReceivers receivers_;
  std::array<DeviceIdentity, 3> first_;
};

TEST_F(WacomReceiverTest, StandsForNothingUntilItSaysWhatItHears) {
  for (const DeviceIdentity& identity : first_) {
    EXPECT_EQ(identity.product, k_wacom_receiver);
    EXPECT_FALSE(make_decoder(identity).ok());
    EXPECT_FALSE(make_hand_decoders(identity).touch);
  }
  EXPECT_TRUE(is_receiver_monitor(first_[0]));
  EXPECT_FALSE(is_receiver_monitor(first_[1]));
}

TEST_F(WacomReceiverTest, ItsInterfacesBringThePenTheKeysAndTheFingersOfTheTablet) {
  const auto changes = hear(k_intuos5_s);
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_TRUE(is_receiver_monitor(changes[0].identity)) << "which stays what it is";
  EXPECT_EQ(receivers_.shown(0)->name, "Wacom Intuos5 touch S (wireless)") << "and is that tablet's for its user";
  const DeviceIdentity& pen_side = changes[1].identity;
  EXPECT_EQ(pen_side.product, k_intuos5_s);
  const auto pen = make_decoder(pen_side);
  ASSERT_TRUE(pen.ok());
  EXPECT_EQ(pen->decoder->axes().x.maximum, 31496);
  const auto keys = make_hand_decoders(pen_side);
  ASSERT_TRUE(keys.pad);
  EXPECT_FALSE(keys.touch);
  EXPECT_TRUE(keys.pad->decode(tests::pad_report(2, 20)));
  EXPECT_EQ(keys.pad->sample().keys, PadKeys{PadKey::button1});
  EXPECT_EQ(keys.pad->sample().ring[0], 20);
  const auto fingers = make_hand_decoders(changes[2].identity);
  EXPECT_FALSE(fingers.pad);
  ASSERT_TRUE(fingers.touch);
  EXPECT_TRUE(fingers.touch->decode(tests::wacom_touch64({{2, true, 0x125, 0x346}})));
  ASSERT_EQ(fingers.touch->contacts().size(), 1U);
  EXPECT_EQ(fingers.touch->contacts()[0].x, 0x125);
  EXPECT_EQ(fingers.touch->contacts()[0].y, 0x346);
}

TEST_F(WacomReceiverTest, TheKeysOfABambooComeWithItsFingers) {
  const auto changes = hear(k_bamboo);
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_TRUE(make_decoder(changes[1].identity).ok());
  EXPECT_FALSE(make_hand_decoders(changes[1].identity).pad);
  const auto hand = make_hand_decoders(changes[2].identity);
  ASSERT_TRUE(hand.pad);
  ASSERT_TRUE(hand.touch);
  EXPECT_EQ(hand.touch->axes().x.maximum, 4096) << "as by cable, where they come in messages too";
}

TEST_F(WacomReceiverTest, IsToldOnceAndAgainWhenTheTabletGoes) {
  EXPECT_EQ(hear(k_intuos5_s).size(), 3U);
  EXPECT_TRUE(hear(k_intuos5_s).empty());
  EXPECT_EQ(hear(0).size(), 3U);
  EXPECT_EQ(receivers_.shown(1)->product, k_wacom_receiver);
  EXPECT_TRUE(hear(0).empty());
  const auto other = hear(k_bamboo);
  ASSERT_EQ(other.size(), 3U);
  EXPECT_EQ(other[1].identity.product, k_bamboo);
}

TEST_F(WacomReceiverTest, AnUnknownTabletIsLeftAlone) {
  const auto changes = hear(0x1234);
  ASSERT_EQ(changes.size(), 3U);
  for (const auto& change : changes) EXPECT_EQ(change.identity.product, k_wacom_receiver);
}

TEST_F(WacomReceiverTest, OnlyItsFirstInterfaceSpeaksOfTheTablet) {
  EXPECT_TRUE(hear(k_intuos5_s, 1).empty());
  tests::Report wrong = tests::receiver_status(k_intuos5_s);
  wrong.pop_back();
  EXPECT_TRUE(receivers_.report(0, wrong).empty()) << "of another length";
  wrong = tests::receiver_status(k_intuos5_s);
  wrong[0] = 0x81;
  EXPECT_TRUE(receivers_.report(0, wrong).empty()) << "of another kind";
  EXPECT_TRUE(receivers_.report(9, tests::receiver_status(k_intuos5_s)).empty()) << "of a device that nobody declared";
}

TEST_F(WacomReceiverTest, TwoReceiversHearATabletEach) {
  for (int i = 0; i < 3; ++i) (void)receivers_.connect(10 + i, tests::receiver(i, "usb-2"));
  hear(k_intuos5_s);
  EXPECT_EQ(receivers_.shown(11)->product, k_wacom_receiver);
  hear(k_bamboo, 10);
  EXPECT_EQ(receivers_.shown(11)->product, k_bamboo);
  EXPECT_EQ(receivers_.shown(1)->product, k_intuos5_s);
}

TEST_F(WacomReceiverTest, AnInterfaceThatComesAgainIsTheTabletsAtOnceButForTheFirst) {
  hear(k_intuos5_s);
  EXPECT_EQ(receivers_.connect(5, tests::receiver(1)).product, k_intuos5_s) << "the kernel makes its node anew";
  (void)receivers_.connect(0, tests::receiver(0));
  EXPECT_EQ(receivers_.connect(1, tests::receiver(1)).product, k_wacom_receiver) << "plugged in anew it hears nothing";
  EXPECT_EQ(hear(k_intuos5_s).size(), 4U);
}

TEST_F(WacomReceiverTest, ARecordingWithoutNumbersTellsItsInterfacesByTheirReports) {
  WacomReceivers receivers;
  for (int i = 0; i < 3; ++i) {
    DeviceIdentity identity = tests::receiver(i, "");
    identity.interface_number.reset();
    (void)receivers.connect(i, identity);
  }
  EXPECT_EQ(receivers.report(0, tests::receiver_status(k_intuos5_s)).size(), 3U);
  EXPECT_TRUE(receivers.report(1, tests::receiver_status(k_bamboo)).empty());
}

TEST_F(WacomReceiverTest, TellsTheCharge) {
  ReceiverMonitor monitor;
  EXPECT_FALSE(monitor.decode(tests::receiver_status(k_intuos5_s, 20, true)));
  EXPECT_EQ(monitor.battery(), (Battery{20 * 100 / 31, true}));
  monitor.decode(tests::receiver_status(k_intuos5_s, 63));
  EXPECT_EQ(monitor.battery(), (Battery{100, false})) << "more than full is full";
  monitor.decode(tests::receiver_status(0));
  EXPECT_EQ(monitor.battery(), Battery{}) << "that of nothing is none";
  EXPECT_TRUE(make_hand_decoders(tests::receiver(0)).pad);
  EXPECT_FALSE(make_hand_decoders(tests::receiver(0)).pad->features().any());
}

TEST_F(WacomReceiverTest, OtherDevicesPassThrough) {
  const DeviceIdentity tablet = tests::intuos_pro();
  EXPECT_EQ(receivers_.connect(7, tablet).product, tablet.product);
  EXPECT_EQ(receivers_.shown(7), nullptr);
  EXPECT_TRUE(receivers_.last_status(7).empty());
  hear(k_bamboo);
  EXPECT_EQ(receivers_.last_status(0).size(), 32U);
}

}  // namespace
}  // namespace penpose::decode
