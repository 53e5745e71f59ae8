// Reports of any content for the keys and wheels of every protocol of the table: the first byte chooses one.

#include "tests/support/hands/hand_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(base::Bytes(data, size));
  static const auto names = fuzz::protocols_with([](const decode::HandDecoders& made) { return made.pad != nullptr; });
  auto hand = fuzz::choose_protocol(reader, names);
  fuzz::try_reports({std::move(hand.pad), nullptr}, reader);
  return 0;
}
