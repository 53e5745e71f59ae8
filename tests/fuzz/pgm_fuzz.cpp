#include <cstddef>
#include <cstdint>

#include "core/model_io/label_file.h"
#include "core/model_io/read_pgm.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::model_io::read_pgm({data, size});
  (void)penpose::model_io::read_label_file({data, size});
  return 0;
}
