#include <cstddef>
#include <cstdint>

#include "core/io/project/cast_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto cast = penpose::io::read_cast({data, size});
  if (cast.ok()) (void)penpose::io::write_cast(*cast).ok();
  (void)penpose::io::read_cast_note({data, size}).ok();
  return 0;
}
