#include "firmware_io/decode/wacom/hand/wacom_hands.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/wacom/wacom_models.h"

namespace penpose::decode {
namespace {

TEST(WacomHands, AreOrderedByProduct) {
  std::uint16_t last = 0;
  for (const WacomHand& hand : wacom_hands()) {
    EXPECT_GT(hand.product, last);
    last = hand.product;
  }
}

TEST(WacomHands, BelongToModelsOfTheTable) {
  for (const WacomHand& hand : wacom_hands()) {
    if (hand.touch == WacomTouch::bamboo_pad) continue;  // its pen describes itself
    bool found = false;
    for (const WacomModel& model : wacom_models()) found = found || model.product == hand.product;
    EXPECT_TRUE(found) << std::hex << hand.product;
    EXPECT_TRUE(hand.pad != WacomPad::none || hand.touch != WacomTouch::none) << std::hex << hand.product;
  }
}

TEST(WacomHands, AreFoundOnTheirBusAlone) {
  ASSERT_NE(find_wacom_hand(k_bus_usb, k_vendor_wacom, 0x0314), nullptr);
  EXPECT_EQ(find_wacom_hand(k_bus_usb, k_vendor_wacom, 0x0314)->keys, 7);
  EXPECT_EQ(find_wacom_hand(k_bus_bluetooth, k_vendor_wacom, 0x0314), nullptr);
  EXPECT_NE(find_wacom_hand(k_bus_bluetooth, k_vendor_wacom, 0x0360), nullptr);
  EXPECT_EQ(find_wacom_hand(k_bus_usb, k_vendor_wacom, 0x0360), nullptr);
  EXPECT_EQ(find_wacom_hand(k_bus_usb, 0x1b96, 0x0314), nullptr);
  EXPECT_NE(find_wacom_hand(k_bus_usb, k_vendor_lenovo, 0x6004), nullptr);
  EXPECT_EQ(find_wacom_hand(k_bus_usb, k_vendor_wacom, 0x6004), nullptr);
  EXPECT_EQ(find_wacom_hand(k_bus_usb, k_vendor_wacom, 0x0041), nullptr);
}

}  // namespace
}  // namespace penpose::decode
