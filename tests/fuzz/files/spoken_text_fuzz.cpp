#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/phonetics/phones.h"

/// A text, and the dictionary behind its first line.
// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const penpose::base::Bytes bytes(data, size);
  const std::string_view text = penpose::base::as_text(bytes);
  (void)penpose::speech::phonemes_of(text.substr(0, text.find('\n')), bytes);
  return 0;
}
