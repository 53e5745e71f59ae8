#include <cstddef>
#include <cstdint>

#include "core/io/project/camera_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::io::read_camera({data, size}).ok();
  return 0;
}
