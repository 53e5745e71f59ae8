#include <cstddef>
#include <cstdint>

#include "core/io/tracks/label_file.h"
#include "core/io/tracks/read_pgm.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::io::read_pgm({data, size});
  (void)penpose::io::read_label_file({data, size});
  return 0;
}
