// Descriptors and reports of any content for the fingers that Wacom's later tablets describe.

#include "firmware_io/decode/wacom/hand/wacom_generic_touch_decoder.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::try_described_touch<decode::WacomGenericTouchDecoder>(base::ByteReader(base::Bytes(data, size)),
                                                              decode::find_wacom_fingers, nullptr);
  return 0;
}
