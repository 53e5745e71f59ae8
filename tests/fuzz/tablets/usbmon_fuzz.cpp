// Any bytes as a capture of USB requests: what comes out is a trace, the same in pieces of any size. Only reports that
// were captured in part, and a cut at the end, may not be read of it.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "replay/recording/usb/usb_recording.h"
#include "replay/trace/trace_reader.h"

using namespace penpose;

namespace {

struct Converted {
  std::string text;
  std::string error;
};

Converted convert(base::Bytes bytes, std::size_t piece) {
  replay::UsbRecording recording(
      [rest = bytes, piece](std::span<std::uint8_t> into) mutable -> base::Result<std::size_t> {
        const std::size_t count = std::min({piece, rest.size(), into.size()});
        std::copy_n(rest.begin(), count, into.begin());
        rest = rest.subspan(count);
        return count;
      });
  Converted all;
  for (;;) {
    const auto more = recording.next(all.text);
    if (!more) {
      all.error = more.error().line();
      if (all.error.empty()) std::abort();
      return all;
    }
    if (!*more) return all;
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const base::Bytes bytes(data, size);
  const Converted whole = convert(bytes, size + 1);
  const Converted pieces = convert(bytes, 1 + (size == 0 ? 0 : data[size - 1] % 61));
  if (whole.text != pieces.text || whole.error != pieces.error) std::abort();
  // 5 bytes a byte of the file, and what stands around the descriptors.
  if (whole.text.size() > 64 * size + (std::size_t{1} << 20)) std::abort();
  replay::TraceReader reader(replay::read_from(base::as_bytes(whole.text)));
  std::int64_t time_us = 0;
  for (;;) {
    const auto line = reader.next();
    if (!line) std::abort();
    if (!line->has_value()) break;
    if (!(*line)->problem.empty() && !(*line)->text.starts_with("E: ")) std::abort();
    if ((*line)->kind != replay::TraceLineKind::report) continue;
    if ((*line)->time_us < time_us) std::abort();
    time_us = (*line)->time_us;
  }
  return 0;
}
