// Reports of any content for the fingers of every protocol of the table: the first byte chooses one.

#include "firmware_io/decode/layout/protocol.h"
#include "tests/support/hands/hand_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(base::Bytes(data, size));
  static const auto names = [] {
    std::vector<std::string> all;
    for (const auto& [name, protocol] : decode::known_protocols()) {
      if (decode::make_protocol_hand_decoders(name).touch) all.push_back(name);
    }
    return all;
  }();
  auto hand = decode::make_protocol_hand_decoders(names[reader.read<std::uint8_t>().value_or(0) % names.size()]);
  fuzz::try_reports({nullptr, std::move(hand.touch)}, reader);
  return 0;
}
