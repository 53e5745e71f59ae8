#include <cstddef>
#include <cstdint>

#include "ui/cli/camera_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::cli::read_camera({data, size}).ok();
  return 0;
}
