#include <cstddef>
#include <cstdint>

#include "core/speech/mouth_file.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::speech::read_mouth_file({data, size});
  return 0;
}
