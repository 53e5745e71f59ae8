// Reports of any content for the fingers of every protocol of the table: the first byte chooses one.

#include "tests/support/hands/hand_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(base::Bytes(data, size));
  static const auto names =
      fuzz::protocols_with([](const decode::HandDecoders& made) { return made.touch != nullptr; });
  auto hand = fuzz::choose_protocol(reader, names);
  fuzz::try_reports({nullptr, std::move(hand.touch)}, reader);
  return 0;
}
