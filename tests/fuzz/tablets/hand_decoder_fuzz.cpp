// Reports of any content for every way of reading keys, wheels and fingers: the first bytes choose the device and carry
// its descriptor, the rest are reports (tests/support/hands/hand_reports.h).

#include "firmware_io/decode/wacom/hand/wacom_hands.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

namespace {

decode::DeviceIdentity chosen_device(base::ByteReader& reader) {
  decode::DeviceIdentity device;
  const std::uint8_t choice = reader.read<std::uint8_t>().value_or(0);
  const auto hands = decode::wacom_hands();
  device.vendor = decode::k_vendor_wacom;
  if (choice < hands.size()) {
    device.product = hands[choice].product;
    device.bus = decode::find_wacom_hand(decode::k_bus_usb, device.vendor, device.product) != nullptr
                     ? decode::k_bus_usb
                     : decode::k_bus_bluetooth;
  } else if (choice < 240) {
    const auto tablets = decode::known_tablets().tablets();
    const auto& tablet = tablets[(choice - hands.size()) * 3 % tablets.size()];
    const auto& identifier = tablet.identifiers.empty() ? tablet.pads.front() : tablet.identifiers.front();
    device.vendor = identifier.vendor;
    device.product = identifier.product;
    device.input_report_length = identifier.input_report_length;
  } else {
    device.product = choice % 4 == 0 ? 0x0357 : 0xfff0;  // described; the first turns its ring round
    if (choice % 2 == 1) device.vendor = 0x1b96;
  }
  device.report_descriptor = fuzz::read_descriptor(reader);
  return device;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(base::Bytes(data, size));
  auto hand = decode::make_hand_decoders(chosen_device(reader));
  fuzz::try_reports(std::move(hand), reader);
  return 0;
}
