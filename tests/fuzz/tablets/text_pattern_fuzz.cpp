// The bytes up to the first zero are a pattern, the rest is the text.

#include <cstdint>

#include "core/base/byte_reader.h"
#include "firmware_io/decode/table/text_pattern.h"

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto all = penpose::base::as_text({data, size});
  const auto zero = all.find('\0');
  const auto pattern = penpose::decode::TextPattern::parse(all.substr(0, zero));
  if (pattern && zero != std::string_view::npos) (void)pattern->found_in(all.substr(zero + 1));
  return 0;
}
