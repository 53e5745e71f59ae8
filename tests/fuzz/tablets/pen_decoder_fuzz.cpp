// Reports of any content for every way of reading a pen: the first bytes choose the device and carry its descriptor,
// the rest are reports with their lengths in front.

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/sample/pen_events.h"
#include "tests/support/hands/chosen_device.h"

using namespace penpose;

namespace {

decode::DeviceIdentity chosen_device(base::ByteReader& reader) {
  decode::DeviceIdentity device;
  const std::uint8_t choice = reader.read<std::uint8_t>().value_or(0);
  // Beside a tablet of the other table is whatever its descriptor will be.
  if (!fuzz::choose_known(device, choice, decode::wacom_models(), decode::find_wacom_model, 4)) {
    device.product = 0xffff;  // in no table
    if (choice % 2 == 0) device.vendor = 0x1b96;
  }
  const std::size_t length = reader.read<std::uint8_t>().value_or(0);
  if (const auto descriptor = reader.take(length))
    device.report_descriptor.assign(descriptor->begin(), descriptor->end());
  return device;
}

std::vector<decode::PenEvent> run(decode::PenDecoder& decoder, base::ByteReader reader) {
  decode::PenEvents events;
  std::vector<decode::PenEvent> all;
  std::int64_t time_us = 0;
  while (const auto length = reader.read<std::uint8_t>()) {
    // A length beyond the end takes what is left, so that every byte counts.
    const auto report = reader.take(*length <= reader.remaining() ? *length : reader.remaining());
    time_us += 1000;
    if (decoder.decode(*report) != decode::ReportKind::pen) continue;
    if (decoder.frames().empty() || decoder.frames().back() != decoder.sample()) std::abort();
    for (const decode::PenSample& sample : decoder.frames()) {
      if (sample.in_range != (sample.tool != decode::Tool::none)) std::abort();
      events.add(sample, time_us, all);
    }
  }
  events.finish(time_us, all);
  return all;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(base::Bytes(data, size));
  auto made = decode::make_decoder(chosen_device(reader));
  if (!made) return 0;
  const auto first = run(*made->decoder, reader);
  // A reset leaves nothing behind: the same reports give the same events.
  made->decoder->reset();
  const auto second = run(*made->decoder, reader);
  if (first.size() != second.size()) std::abort();
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i].kind != second[i].kind || first[i].sample != second[i].sample) std::abort();
  }
  return 0;
}
