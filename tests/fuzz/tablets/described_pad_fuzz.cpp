// Descriptors and reports of any content for keys that any tablet describes, alone and beside a vendor's protocol.

#include "firmware_io/decode/described/described_pad_decoder.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(base::Bytes(data, size));
  const bool vendor = reader.read<std::uint8_t>().value_or(0) % 2 != 0;
  const auto parsed = hid::parse_report_descriptor(fuzz::read_descriptor(reader), hid::Strictness::tolerant);
  if (!parsed) return 0;
  auto pad = decode::find_described_pad(*parsed);
  if (!pad) return 0;
  auto other = vendor ? decode::make_protocol_hand_decoders("huion_ring").pad : nullptr;
  fuzz::try_reports({std::make_unique<decode::DescribedPadDecoder>(std::move(*pad), decode::find_battery(*parsed),
                                                                   std::move(other), vendor ? 6 : 0),
                     nullptr},
                    reader);
  return 0;
}
