// Reports of any content for the keys of Wacom's tablets that do not describe themselves: the first byte chooses one.

#include "firmware_io/decode/wacom/hand/wacom_hands.h"
#include "firmware_io/decode/wacom/hand/wacom_pad_decoder.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(base::Bytes(data, size));
  const auto hands = decode::wacom_hands();
  const auto& hand = hands[reader.read<std::uint8_t>().value_or(0) % hands.size()];
  if (hand.pad == decode::WacomPad::none) return 0;
  fuzz::try_reports({std::make_unique<decode::WacomPadDecoder>(hand), nullptr}, reader);
  return 0;
}
