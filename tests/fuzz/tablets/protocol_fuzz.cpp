// The first byte chooses a protocol; then each report is a length byte and that many bytes. All reports go to one
// decoder.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "firmware_io/decode/layout/protocol.h"

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace decode = penpose::decode;
  if (size == 0) return 0;
  const auto names = decode::protocol_names();
  const auto decoder = decode::make_protocol_decoder(names[data[0] % names.size()]);
  for (std::size_t at = 1; at < size;) {
    const std::size_t length = std::min<std::size_t>(data[at], size - at - 1);
    // A copy of its own size lets the sanitizer see a read past the report.
    const std::vector<std::uint8_t> report(data + at + 1, data + at + 1 + length);
    decoder->decode(report);
    const auto& sample = decoder->sample();
    if (sample.in_range == (sample.tool == decode::Tool::none)) std::abort();
    if (!sample.in_range && (sample.tip || sample.buttons != 0)) std::abort();
    at += length + 1;
  }
  decoder->reset();
  if (decoder->sample() != decode::PenSample{}) std::abort();
  return 0;
}
