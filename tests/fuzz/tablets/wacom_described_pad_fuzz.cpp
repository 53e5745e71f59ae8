// Descriptors and reports of any content for the keys that Wacom's later tablets describe.

#include "firmware_io/decode/wacom/hand/wacom_generic_pad_decoder.h"
#include "firmware_io/hid/report_descriptor.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(base::Bytes(data, size));
  const std::uint16_t product =
      reader.read<std::uint8_t>().value_or(0) % 2 == 0 ? 0x0357 : 0xfff0;  // the first turns its ring
  const auto parsed = hid::parse_report_descriptor(fuzz::read_descriptor(reader), hid::Strictness::tolerant);
  if (!parsed) return 0;
  auto layout = decode::find_wacom_pad(*parsed, product);
  if (!layout) return 0;
  fuzz::try_reports({std::make_unique<decode::WacomGenericPadDecoder>(std::move(*layout), nullptr), nullptr}, reader);
  return 0;
}
