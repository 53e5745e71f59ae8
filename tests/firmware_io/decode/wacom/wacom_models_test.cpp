#include "firmware_io/decode/wacom/wacom_models.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/sample/device_identity.h"

namespace penpose::decode {
namespace {

TEST(WacomModels, AreOrderedByProductSoThatEachIsFound) {
  for (const WacomModel& model : wacom_models()) {
    const bool lenovo = model.product == 0x6004;
    const std::uint16_t vendor = lenovo ? k_vendor_lenovo : k_vendor_wacom;
    const auto* usb = find_wacom_model(k_bus_usb, vendor, model.product);
    const auto* bluetooth = find_wacom_model(k_bus_bluetooth, vendor, model.product);
    EXPECT_NE(usb == &model, bluetooth == &model) << model.name;
  }
}

TEST(WacomModels, OtherVendorsAndBusesHaveNone) {
  constexpr std::uint16_t k_bus_i2c = 0x18;
  EXPECT_NE(find_wacom_model(k_bus_usb, k_vendor_wacom, 0x0013), nullptr);
  EXPECT_EQ(find_wacom_model(k_bus_i2c, k_vendor_wacom, 0x0013), nullptr);
  EXPECT_EQ(find_wacom_model(k_bus_usb, 0x256c, 0x0013), nullptr);
  EXPECT_EQ(find_wacom_model(k_bus_usb, k_vendor_lenovo, 0x0013), nullptr);
  EXPECT_EQ(find_wacom_model(k_bus_usb, k_vendor_wacom, 0x0357), nullptr);  // describes itself
}

}  // namespace
}  // namespace penpose::decode
