#include <cstddef>
#include <cstdint>

#include "core/io/tracks/map_file.h"
#include "core/io/tracks/track_formats.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::io::read_map_file({data, size});
  (void)penpose::io::format_of_track({data, size});
  return 0;
}
