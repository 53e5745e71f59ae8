// Reports of any content for the fingers on Wacom's tablets that do not describe their reports: the first byte chooses
// one, its descriptor, which tells of axes and kinds of fingers, follows.

#include "firmware_io/decode/wacom/hand/wacom_hands.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(base::Bytes(data, size));
  const auto hands = decode::wacom_hands();
  const auto& chosen = hands[reader.read<std::uint8_t>().value_or(0) % hands.size()];
  decode::DeviceIdentity device;
  device.vendor = decode::k_vendor_wacom;
  device.product = chosen.product;
  if (decode::find_wacom_hand(device.bus, device.vendor, device.product) == nullptr)
    device.bus = decode::k_bus_bluetooth;
  device.report_descriptor = fuzz::read_descriptor(reader);
  fuzz::try_reports({nullptr, decode::make_hand_decoders(device).touch}, reader);
  return 0;
}
