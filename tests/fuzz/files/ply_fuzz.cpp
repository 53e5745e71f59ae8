#include <cstddef>
#include <cstdint>

#include "core/io/surface/read_ply.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::io::read_ply({data, size});
  return 0;
}
