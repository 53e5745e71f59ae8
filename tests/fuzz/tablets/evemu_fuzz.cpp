// Any text behind the first line of an evemu recording: in pieces of any size it gives the same reports, which decoders
// take, and descriptors that can be read.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/event/evemu_line.h"
#include "firmware_io/hid/report_descriptor.h"
#include "replay/recording/recording.h"
#include "tests/support/trace_reports.h"

using namespace penpose;

namespace {

void decode_all(base::Bytes bytes) {
  replay::TraceSource source(replay::read_recording(replay::read_from(bytes)));
  std::unique_ptr<decode::PenDecoder> pen;
  decode::HandDecoders hand;
  source.listen({}, [&](int, const decode::DeviceIdentity& identity) {
    if (!hid::parse_report_descriptor(identity.report_descriptor)) std::abort();
    auto found = decode::make_decoder(identity);
    pen = found ? std::move(found->decoder) : nullptr;
    hand = decode::make_hand_decoders(identity);
  });
  for (auto report = source.next(); report && report->has_value(); report = source.next()) {
    if (pen) pen->decode((*report)->bytes);
    if (hand.pad) hand.pad->decode((*report)->bytes);
    if (hand.touch) hand.touch->decode((*report)->bytes);
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = "# EVEMU 1.3\n" + std::string(base::as_text(base::Bytes(data, size)));
  const base::Bytes bytes = base::as_bytes(text);
  const std::size_t piece = size == 0 ? 1 : 1 + data[size / 2] % 61;
  const std::string reports = tests::reports_of(replay::read_recording(replay::read_from(bytes)));
  if (reports != tests::reports_of(replay::read_recording(tests::in_pieces(bytes, piece)))) std::abort();
  decode_all(bytes);
  return 0;
}
