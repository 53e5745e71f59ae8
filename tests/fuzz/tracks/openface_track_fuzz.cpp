#include <cstddef>
#include <cstdint>

#include "core/io/tracks/openface/openface_units.h"
#include "core/io/tracks/read_track.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::io::read_openface_track({data, size});
  (void)penpose::io::read_openface_units({data, size});
  return 0;
}
