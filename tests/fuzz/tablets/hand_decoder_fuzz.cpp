// Reports of any content for every way of reading keys, wheels and fingers: the first bytes choose the device and carry
// its descriptor, the rest are reports (tests/support/hands/hand_reports.h).

#include "firmware_io/decode/wacom/hand/wacom_hands.h"
#include "tests/support/hands/chosen_device.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

namespace {

decode::DeviceIdentity chosen_device(base::ByteReader& reader) {
  decode::DeviceIdentity device;
  const std::uint8_t choice = reader.read<std::uint8_t>().value_or(0);
  if (!fuzz::choose_known(device, choice, decode::wacom_hands(), decode::find_wacom_hand, 3)) {
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
