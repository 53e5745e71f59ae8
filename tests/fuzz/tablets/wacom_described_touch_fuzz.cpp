// Descriptors and reports of any content for the fingers that Wacom's later tablets describe.

#include "firmware_io/decode/wacom/hand/wacom_generic_touch_decoder.h"
#include "firmware_io/hid/report_descriptor.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(base::Bytes(data, size));
  const auto parsed = hid::parse_report_descriptor(fuzz::read_descriptor(reader), hid::Strictness::tolerant);
  if (!parsed) return 0;
  auto fingers = decode::find_wacom_fingers(*parsed);
  if (!fingers) return 0;
  fuzz::try_reports({nullptr, std::make_unique<decode::WacomGenericTouchDecoder>(std::move(*fingers), nullptr)},
                    reader);
  return 0;
}
