#include <cstddef>
#include <cstdint>

#include "core/model_io/map_file.h"
#include "core/model_io/track_format.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::model_io::read_map_file({data, size});
  (void)penpose::model_io::format_of_track({data, size});
  return 0;
}
