// Descriptors and reports of any content for fingers that any other device describes.

#include "firmware_io/decode/described/multitouch_decoder.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::try_described_touch<decode::MultitouchDecoder>(base::ByteReader(base::Bytes(data, size)),
                                                       decode::find_multitouch);
  return 0;
}
